#include "core/synthesis/search_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiaro::synthesis {

namespace {

constexpr int largestStep = 63;
std::ptrdiff_t roundedUp(std::ptrdiff_t value, std::ptrdiff_t step) {
    return (value + step - 1) / step * step;
}

// Rows that are an odd number of cache lines apart spread over the whole first-level cache.
std::ptrdiff_t oddLines(std::ptrdiff_t entries) {
    constexpr std::ptrdiff_t line = 64 / sizeof(std::uint32_t);
    return (roundedUp(entries, line) / line | 1) * line;
}

}  // namespace

Image<SearchPixel> halved(const Image<SearchPixel>& pixels) {
    Image<SearchPixel> half((pixels.width() + 1) / 2, (pixels.height() + 1) / 2);
    for (int y = 0; y < half.height(); ++y)
        for (int x = 0; x < half.width(); ++x) {
            glm::ivec3 sum(0);
            int count = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, pixels.height()); ++j)
                for (int i = 2 * x; i < std::min(2 * x + 2, pixels.width()); ++i) {
                    const SearchPixel& pixel = pixels(i, j);
                    if (!pixel.counts) continue;
                    sum += glm::ivec3(pixel.r, pixel.g, pixel.b);
                    ++count;
                }
            if (count == 0) continue;
            const auto mean = [count](int total) {
                return std::int8_t((total + (total < 0 ? -count : count) / 2) / count);
            };
            half(x, y) = {mean(sum.r), mean(sum.g), mean(sum.b), true};
        }
    return half;
}

SearchTexture::SearchTexture(const ColorImage& texture) : m_pixels(texture.width(), texture.height()) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& color : texture.pixels()) {
        low = glm::min(low, color);
        high = glm::max(high, color);
    }
    m_middle = (low + high) * 0.5f;
    const glm::vec3 reach = (high - low) * 0.5f;
    const double widest = std::max({reach.r, reach.g, reach.b});
    m_step = widest > 0 ? widest / largestStep : 1;

    std::ranges::transform(texture.pixels(), m_pixels.pixels().begin(), [this](const glm::vec3& color) {
        SearchPixel pixel = rounded(color);
        pixel.counts = true;
        return pixel;
    });
    pack();
    m_half.reset(new SearchTexture(halved(m_pixels)));
}

SearchTexture::SearchTexture(Image<SearchPixel> pixels) : m_pixels(std::move(pixels)) {
    pack();
}

void SearchTexture::pack() {
    packQuads();
    integrateSquares();
}

SearchPixel SearchTexture::rounded(const glm::vec3& color) const {
    const auto channel = [this](float value, float middle) {
        const double steps = std::round((double(value) - double(middle)) / m_step);
        return std::int8_t(std::clamp(steps, double(-largestStep), double(largestStep)));
    };
    return {channel(color.r, m_middle.r), channel(color.g, m_middle.g), channel(color.b, m_middle.b), false};
}

void SearchTexture::packQuads() {
    const int padded = width() + kernels::columnPadding;
    m_quadPitch = oddLines(padded);
    m_quads.assign(std::size_t(m_quadPitch * 3 * (height() + kernels::rowPadding)), 0);
    std::vector<std::uint8_t> bytes(std::size_t(3 * padded + 6), searchByteOffset);
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x) {
            const SearchPixel& pixel = m_pixels(x, y);
            std::uint8_t* at = bytes.data() + 3 * x;
            at[0] = std::uint8_t(pixel.r + searchByteOffset);
            at[1] = std::uint8_t(pixel.g + searchByteOffset);
            at[2] = std::uint8_t(pixel.b + searchByteOffset);
        }
        for (int phase = 0; phase < 3; ++phase) {
            std::uint32_t* row = m_quads.data() + (3 * y + phase) * m_quadPitch;
            for (int x = 0; x < padded; ++x) {
                const std::uint8_t* quad = bytes.data() + 3 * x + phase;
                row[x] = quad[0] | std::uint32_t(quad[1]) << 8 | std::uint32_t(quad[2]) << 16 |
                         std::uint32_t(quad[3]) << 24;
            }
        }
    }
}

void SearchTexture::integrateSquares() {
    m_squaresPitch = oddLines(width() + 1 + kernels::columnPadding);
    m_squares.assign(std::size_t(m_squaresPitch * (height() + 1 + kernels::rowPadding)), 0);
    for (int y = 0; y < height(); ++y) {
        const std::uint32_t* above = m_squares.data() + y * m_squaresPitch;
        std::uint32_t* row = m_squares.data() + (y + 1) * m_squaresPitch;
        std::uint32_t sum = 0;
        for (int x = 0; x < width(); ++x) {
            sum += squared(m_pixels(x, y));
            row[x + 1] = above[x + 1] + sum;
        }
    }
}

kernels::PackedSource SearchTexture::packed() const {
    return {m_quads.data(), m_quadPitch, m_squares.data(), m_squaresPitch};
}

}  // namespace chiaro::synthesis
