#include "core/export/bake.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace chiaro::exporting {

namespace {

constexpr int nowhere = std::numeric_limits<int>::max();

/// For each pixel of a row, the rows of the nearest covered pixels of its column are known; finds which of
/// those is nearest in the plane, as the lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012).
class RowEnvelope {
public:
    explicit RowEnvelope(int width) : m_columns(std::size_t(width)), m_begins(std::size_t(width) + 1) {}

    /// `nearest` holds a row for each column, or nowhere; visit(x, column) tells the column to copy from.
    template <class Visit>
    void find(std::span<const int> nearest, int y, Visit visit) {
        int count = 0;
        const auto height = [&](int column) {
            const double d = double(nearest[std::size_t(column)]) - y;
            return d * d + double(column) * column;
        };
        for (int x = 0; x < int(nearest.size()); ++x) {
            if (nearest[std::size_t(x)] == nowhere) continue;
            double begin = -std::numeric_limits<double>::infinity();
            for (; count > 0; --count) {
                const int last = m_columns[std::size_t(count - 1)];
                begin = (height(x) - height(last)) / (2.0 * (x - last));
                if (begin > m_begins[std::size_t(count - 1)]) break;
                begin = -std::numeric_limits<double>::infinity();
            }
            m_columns[std::size_t(count)] = x;
            m_begins[std::size_t(count++)] = begin;
        }
        if (count == 0) return;
        int current = 0;
        for (int x = 0; x < int(nearest.size()); ++x) {
            while (current + 1 < count && m_begins[std::size_t(current + 1)] < x) ++current;
            visit(x, m_columns[std::size_t(current)]);
        }
    }

private:
    std::vector<int> m_columns;
    std::vector<double> m_begins;
};

}  // namespace

void dilate(ByteImage& picture, const Image<std::uint8_t>& covered) {
    const int width = picture.width(), height = picture.height();
    Image<int> nearest(width, height, nowhere);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            nearest(x, y) = covered(x, y) != 0 ? y : y > 0 ? nearest(x, y - 1) : nowhere;
    for (int y = height - 2; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const int below = nearest(x, y + 1);
            if (below == nowhere) continue;
            if (nearest(x, y) == nowhere || below - y < y - nearest(x, y)) nearest(x, y) = below;
        }
    tbb::parallel_for(0, height, [&](int y) {
        RowEnvelope envelope(width);
        envelope.find(nearest.row(y), y, [&](int x, int column) {
            // Only pixels without a colour are written, only pixels with one are read.
            if (covered(x, y) == 0) picture(x, y) = picture(column, nearest(column, y));
        });
    });
}

}  // namespace chiaro::exporting
