#include "core/gradient/gradient.h"

#include <algorithm>

namespace chiaro::gradient {

namespace {

/// The column averages that the sort has not used yet, in order of the channel that varies most, so that the
/// search for the nearest one looks only at a slab around the midpoint. Exact: a column is passed over only
/// when its distance along that channel alone is larger than that of the best one.
class UnusedColumns {
public:
    explicit UnusedColumns(const ExactColors& averages) {
        m_axis = widestChannel(averages);
        for (int column = 1; column + 1 < int(averages.size()); ++column)
            m_entries.push_back({averages[std::size_t(column)], column});
        std::sort(m_entries.begin(), m_entries.end(), [this](const Entry& a, const Entry& b) {
            return std::pair(a.color[m_axis], a.column) < std::pair(b.color[m_axis], b.column);
        });
    }

    /// Takes out the column nearest to `middle` among those whose squared distance is less than
    /// `squaredRadius`; -1 when there is none.
    int take(glm::dvec3 middle, double squaredRadius) {
        Best best{squaredRadius, -1, 0};
        const double center = middle[m_axis];
        const auto split = std::lower_bound(m_entries.begin(), m_entries.end(), center,
                                            [this](const Entry& e, double c) { return e.color[m_axis] < c; });
        const auto start = std::size_t(split - m_entries.begin());
        for (std::size_t i = start; i < m_entries.size() && consider(i, middle, best); ++i) {
        }
        for (std::size_t i = start; i > 0 && consider(i - 1, middle, best); --i) {
        }
        if (best.column >= 0) remove(best.index);
        return best.column;
    }

private:
    struct Entry {
        glm::dvec3 color;
        int column;  ///< -1 once used
    };
    struct Best {
        double squaredDistance;
        int column;
        std::size_t index;
    };

    static int widestChannel(const ExactColors& averages) {
        glm::dvec3 low = averages.front(), high = averages.front();
        for (const glm::dvec3& color : averages) {
            low = glm::min(low, color);
            high = glm::max(high, color);
        }
        const glm::dvec3 range = high - low;
        return range.r >= range.g && range.r >= range.b ? 0 : range.g >= range.b ? 1 : 2;
    }

    /// False when no entry further on in this direction can be better.
    bool consider(std::size_t index, glm::dvec3 middle, Best& best) const {
        const Entry& entry = m_entries[index];
        const glm::dvec3 difference = entry.color - middle;
        const double rounding = roundingOf(best.squaredDistance);
        if (difference[m_axis] * difference[m_axis] > best.squaredDistance + rounding) return false;
        if (entry.column < 0) return true;
        const double squaredDistance = glm::dot(difference, difference);
        const bool nearer = squaredDistance < best.squaredDistance - rounding;
        const bool tied =
            std::abs(squaredDistance - best.squaredDistance) <= rounding && best.column > entry.column;
        if (nearer || tied) best = {squaredDistance, entry.column, index};
        return true;
    }

    /// How far the squared distances of two colours that are equally far may lie apart in double: without it,
    /// rounding would choose between the two sides of the midpoint, which grey strips often make equal.
    static double roundingOf(double squaredDistance) { return 4e-15 * std::sqrt(squaredDistance); }

    void remove(std::size_t index) {
        m_entries[index].column = -1;
        if (++m_used * 2 <= m_entries.size()) return;
        std::erase_if(m_entries, [](const Entry& entry) { return entry.column < 0; });
        m_used = 0;
    }

    std::vector<Entry> m_entries;
    std::size_t m_used = 0;
    int m_axis = 0;
};

}  // namespace

std::vector<int> sortColumns(const ExactColors& averages, double searchScale) {
    if (averages.size() < 2) return std::vector<int>(averages.size(), 0);
    UnusedColumns unused(averages);
    std::vector<int> order{0};
    // §3.1's recursion with a stack of its own: sort(A, C) is finished before sort(C, B) begins.
    std::vector<std::pair<int, int>> pending{{0, int(averages.size()) - 1}};
    while (!pending.empty()) {
        const auto [a, b] = pending.back();
        pending.pop_back();
        const glm::dvec3 colorA = averages[std::size_t(a)], colorB = averages[std::size_t(b)];
        const glm::dvec3 across = colorA - colorB;
        const double squaredRadius = searchScale * searchScale / 4 * glm::dot(across, across);
        const int c = unused.take((colorA + colorB) / 2.0, squaredRadius);
        if (c < 0) {
            order.push_back(b);
        } else {
            pending.emplace_back(c, b);
            pending.emplace_back(a, c);
        }
    }
    return order;
}

}  // namespace chiaro::gradient
