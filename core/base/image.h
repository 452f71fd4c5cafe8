#pragma once

#include <glm/glm.hpp>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiaro {

/// A picture held as rows of pixels, top row first; x right, y down. A plain value: copying copies the
/// pixels.
template <class Pixel>
class Image {
public:
    Image() = default;
    Image(int width, int height, Pixel fill = Pixel{})
        : m_width(width), m_height(height), m_pixels(std::size_t(width) * std::size_t(height), fill) {
        assert(width >= 0 && height >= 0);
    }

    int width() const { return m_width; }
    int height() const { return m_height; }
    bool empty() const { return m_pixels.empty(); }
    std::size_t pixelCount() const { return m_pixels.size(); }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }

    Pixel& operator()(int x, int y) { return m_pixels[index(x, y)]; }
    const Pixel& operator()(int x, int y) const { return m_pixels[index(x, y)]; }

    std::span<Pixel> row(int y) { return pixels().subspan(index(0, y), std::size_t(m_width)); }
    std::span<const Pixel> row(int y) const { return pixels().subspan(index(0, y), std::size_t(m_width)); }

    /// All pixels, row after row.
    std::span<Pixel> pixels() { return m_pixels; }
    std::span<const Pixel> pixels() const { return m_pixels; }

    friend bool operator==(const Image&, const Image&) = default;

private:
    std::size_t index(int x, int y) const {
        assert(y >= 0 && y < m_height && x >= 0 && (x < m_width || m_width == 0));
        return std::size_t(y) * std::size_t(m_width) + std::size_t(x);
    }

    int m_width = 0;
    int m_height = 0;
    std::vector<Pixel> m_pixels;
};

/// RGB. Pictures are display-referred in [0, 1]; difference images ("textures", §3.2) lie in [-1, 1].
using ColorImage = Image<glm::vec3>;
/// RGB and coverage, not premultiplied, in [0, 1].
using ColorAlphaImage = Image<glm::vec4>;
/// One value a pixel: light, depth.
using ScalarImage = Image<float>;
/// 0 outside, 1.. the object.
using IdImage = Image<std::uint16_t>;

}  // namespace chiaro
