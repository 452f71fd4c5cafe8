#include "core/synthesis/template_costs.h"

#include <algorithm>

namespace chiaro::synthesis {

namespace {

std::ptrdiff_t roundedUp(std::ptrdiff_t value, std::ptrdiff_t step) {
    return (value + step - 1) / step * step;
}

// The template as the kernels take it.
class TemplatePacker {
public:
    TemplatePacker(const Image<SearchPixel>& pixels, const kernels::PackedSource& source,
                   PackedTemplate& packed)
        : m_pixels(pixels), m_source(source), m_packed(packed) {}

    void pack() {
        for (auto& pieces : m_packed.pieces) pieces.clear();
        m_packed.rectangles.clear();
        sumUp();
        if (m_packed.empty) return;
        layOutBytes();
        for (int column = 0; 4 * column < 3 * m_pixels.width(); ++column) packColumn(column);
        packRectangles();
    }

private:
    void sumUp() {
        m_packed.empty = true;
        std::int64_t sum = 0;
        for (const SearchPixel& pixel : m_pixels.pixels()) {
            if (!pixel.counts) continue;
            m_packed.empty = false;
            sum += squared(pixel) + 2 * searchByteOffset * (pixel.r + pixel.g + pixel.b);
        }
        m_packed.constant = std::uint32_t(sum);
    }

    // The template's rows as bytes, 0 where a pixel doesn't count, and which bytes count.
    void layOutBytes() {
        m_pitch = roundedUp(3 * m_pixels.width(), 4);
        m_packed.bytes.assign(std::size_t(m_pitch * m_pixels.height()), 0);
        m_packed.counts.assign(m_packed.bytes.size(), 0);
        for (int y = 0; y < m_pixels.height(); ++y) {
            std::int8_t* bytes = m_packed.bytes.data() + y * m_pitch;
            std::uint8_t* counts = m_packed.counts.data() + y * m_pitch;
            for (const SearchPixel& pixel : m_pixels.row(y)) {
                if (pixel.counts) {
                    bytes[0] = pixel.r;
                    bytes[1] = pixel.g;
                    bytes[2] = pixel.b;
                    counts[0] = counts[1] = counts[2] = 1;
                }
                bytes += 3;
                counts += 3;
            }
        }
    }

    template <class Byte>
    std::uint32_t fourAt(const std::vector<Byte>& bytes, int column, int y) const {
        std::uint32_t four = 0;
        for (int i = 0; i < 4; ++i)
            four |= std::uint32_t(std::uint8_t(bytes[std::size_t(y * m_pitch + 4 * column + i)])) << (8 * i);
        return four;
    }

    void packColumn(int column) {
        kernels::TemplatePiece piece;
        std::size_t length = 0;
        const auto finish = [&] {
            if (length > 0) m_packed.pieces[length - 1].push_back(piece);
            length = 0;
        };
        for (int y = 0; y < m_pixels.height(); ++y) {
            if (fourAt(m_packed.counts, column, y) == 0) {
                finish();
                continue;
            }
            if (length == 0) piece.offset = (3 * y + 4 * column % 3) * m_source.quadPitch + 4 * column / 3;
            piece.quads[length++] = fourAt(m_packed.bytes, column, y);
            if (length == kernels::longestPiece) finish();
        }
        finish();
    }

    // Runs of pixels that count; equal runs in consecutive rows make one rectangle.
    void packRectangles() {
        struct Run {
            int begin, end, top;
        };
        std::vector<Run> open, now;
        for (int y = 0; y <= m_pixels.height(); ++y) {
            now.clear();
            for (int x = 0; y < m_pixels.height() && x < m_pixels.width(); ++x) {
                if (!m_pixels(x, y).counts) continue;
                const int begin = x;
                while (x < m_pixels.width() && m_pixels(x, y).counts) ++x;
                now.push_back({begin, x, y});
            }
            for (const Run& run : open) {
                const auto same = std::ranges::find_if(
                    now, [&](const Run& other) { return other.begin == run.begin && other.end == run.end; });
                if (same != now.end())
                    same->top = run.top;
                else
                    addRectangle(run.begin, run.end, run.top, y);
            }
            open.swap(now);
        }
    }

    void addRectangle(int left, int right, int top, int bottom) {
        const auto at = [&](int x, int y) { return y * m_source.squaresPitch + x; };
        m_packed.rectangles.push_back({at(left, top), at(right, top), at(left, bottom), at(right, bottom)});
    }

    const Image<SearchPixel>& m_pixels;
    kernels::PackedSource m_source;
    PackedTemplate& m_packed;
    std::ptrdiff_t m_pitch = 0;
};

}  // namespace

void packTemplate(const Image<SearchPixel>& pixels, const SearchTexture& source, PackedTemplate& packed) {
    TemplatePacker(pixels, source.packed(), packed).pack();
}

std::ptrdiff_t costPitch(const CandidateArea& area) {
    return roundedUp(area.width, kernels::columnPadding);
}

void computeCosts(const SearchTexture& source, const PackedTemplate& packed, const CandidateArea& area,
                  std::vector<std::uint32_t>& costs) {
    const std::size_t needed = std::size_t(costPitch(area) * (area.height + kernels::rowPadding));
    if (costs.size() < needed) costs.resize(needed);
    kernels::CostRequest request;
    request.source = source.packed();
    request.x = area.x;
    request.y = area.y;
    request.columns = area.width;
    request.rows = area.height;
    std::ranges::copy(packed.pieces, request.pieces.begin());
    request.rectangles = packed.rectangles;
    request.constant = packed.constant;
    request.costs = costs.data();
    request.pitch = costPitch(area);
    kernels::computeCosts(request);
}

}  // namespace chiaro::synthesis
