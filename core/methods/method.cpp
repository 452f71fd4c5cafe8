#include "core/methods/method.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace chiaro::methods {

namespace {

struct Shader {
    const scene::GBuffer& gbuffer;
    const std::vector<const gradient::Gradient*>& gradients;
    const TextureLookup& texture;

    glm::vec3 color(std::uint16_t object, float light, glm::vec3 difference) const {
        return glm::clamp(gradient::lookUp(*gradients[object - 1u], light) + difference, 0.0f, 1.0f);
    }

    void shadeCentres(int y, Frame& frame) const {
        for (int x = 0; x < gbuffer.width; ++x) {
            const std::uint16_t object = gbuffer.objectId(x, y);
            if (object == 0) continue;
            const float light = gbuffer.light(x, y);
            frame.texture(x, y) = texture(object, x, y, light);
            frame.picture(x, y) = glm::vec4(color(object, light, frame.texture(x, y)), 1);
        }
    }

    /// The mean of the samples that met a surface, and their share as coverage.
    glm::vec4 edgeColor(std::size_t edge) const {
        const std::uint32_t pixel = gbuffer.edgePixels[edge];
        const int x = int(pixel % std::uint32_t(gbuffer.width));
        const int y = int(pixel / std::uint32_t(gbuffer.width));
        constexpr std::size_t samples = scene::GBuffer::samplesPerEdge;
        glm::vec3 sum(0);
        int covered = 0;
        for (std::size_t i = edge * samples; i < (edge + 1) * samples; ++i) {
            const scene::SurfaceSample& sample = gbuffer.edgeSamples[i];
            if (sample.object == 0) continue;
            sum += color(sample.object, sample.light, texture(sample.object, x, y, sample.light));
            ++covered;
        }
        return covered == 0 ? glm::vec4(0) : glm::vec4(sum / float(covered), float(covered) / float(samples));
    }
};

}  // namespace

glm::ivec2 pixelShowing(const scene::GBuffer& gbuffer, std::uint16_t object, glm::ivec2 pixel) {
    static constexpr std::array<glm::ivec2, 9> steps{
        {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (const glm::ivec2 step : steps) {
        const glm::ivec2 beside = pixel + step;
        if (gbuffer.objectId.contains(beside.x, beside.y) && gbuffer.objectId(beside.x, beside.y) == object)
            return beside;
    }
    return {-1, -1};
}

Frame shade(const scene::GBuffer& gbuffer, const std::vector<const gradient::Gradient*>& gradients,
            const TextureLookup& texture, const Task& task) {
    Frame frame{ColorAlphaImage(gbuffer.width, gbuffer.height), ColorImage(gbuffer.width, gbuffer.height)};
    const Shader shader{gbuffer, gradients, texture};
    Task::Steps rows(task, std::size_t(gbuffer.height) + 1);
    tbb::parallel_for(0, gbuffer.height, [&](int y) {
        shader.shadeCentres(y, frame);
        rows.done();
    });
    const std::span<glm::vec4> pixels = frame.picture.pixels();
    tbb::parallel_for(std::size_t(0), gbuffer.edgePixels.size(),
                      [&](std::size_t edge) { pixels[gbuffer.edgePixels[edge]] = shader.edgeColor(edge); });
    rows.done();
    return frame;
}

ColorImage over(const ColorAlphaImage& picture, glm::vec3 background) {
    ColorImage result(picture.width(), picture.height());
    std::transform(picture.pixels().begin(), picture.pixels().end(), result.pixels().begin(),
                   [&](glm::vec4 pixel) { return glm::mix(background, glm::vec3(pixel), pixel.a); });
    return result;
}

}  // namespace chiaro::methods
