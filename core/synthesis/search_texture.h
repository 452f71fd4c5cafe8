#pragma once

#include "core/base/image.h"
#include "core/synthesis/search_kernels.h"

#include <memory>
#include <vector>

namespace chiaro::synthesis {

/// A pixel as the search compares it: RGB in 127 steps, -63..63.
struct SearchPixel {
    std::int8_t r = 0, g = 0, b = 0;
    bool counts = false;  ///< in a template: takes part in the error
};

/// Makes the source's bytes positive: the multiply-add instructions take one signed and one unsigned factor.
inline constexpr int searchByteOffset = 64;

/// r^2 + g^2 + b^2.
inline std::uint32_t squared(const SearchPixel& pixel) {
    return std::uint32_t(pixel.r * pixel.r + pixel.g * pixel.g + pixel.b * pixel.b);
}

/// Half the size, rounded up: each pixel is the mean of those of 2 x 2 that count, and counts where one does.
Image<SearchPixel> halved(const Image<SearchPixel>& pixels);

/// A source texture, prepared once for any number of searches. Immutable, so threads may share it.
///
/// The colours are rounded for the search alone: each channel's middle is subtracted and the widest channel
/// fills 127 steps. What is copied into a picture are the texture's own pixels.
class SearchTexture {
public:
    /// Any size; difference RGB.
    explicit SearchTexture(const ColorImage& texture);

    int width() const { return m_pixels.width(); }
    int height() const { return m_pixels.height(); }
    /// A colour in the texture's steps; colours outside its range go to the end of it.
    SearchPixel rounded(const glm::vec3& color) const;
    /// The texture's own pixels, rounded; all count.
    const Image<SearchPixel>& pixels() const { return m_pixels; }
    /// One step, in units of the texture.
    double step() const { return m_step; }
    kernels::PackedSource packed() const;
    /// The texture at half its size, in the same steps, for draft searches; has no half of its own.
    const SearchTexture& half() const { return *m_half; }

private:
    explicit SearchTexture(Image<SearchPixel> pixels);
    void pack();
    void packQuads();
    void integrateSquares();

    Image<SearchPixel> m_pixels;
    glm::vec3 m_middle{0};
    double m_step = 1;
    std::ptrdiff_t m_quadPitch = 0;
    std::ptrdiff_t m_squaresPitch = 0;
    std::vector<std::uint32_t> m_quads;
    std::vector<std::uint32_t> m_squares;
    std::unique_ptr<const SearchTexture> m_half;
};

}  // namespace chiaro::synthesis
