#include "core/scene/guide.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::scene {

GBuffer gbufferFromGuide(const ScalarImage& light, const IdImage* ids) {
    if (light.empty()) throw Error("guide", "has no pixel", "choose a picture of light in [0, 1]");
    if (ids && (ids->width() != light.width() || ids->height() != light.height()))
        throw Error("guide",
                    fmt::format("is {} x {} px but its ids are {} x {} px", light.width(), light.height(),
                                ids->width(), ids->height()),
                    "choose pictures of one size");
    GBuffer gbuffer;
    gbuffer.width = light.width();
    gbuffer.height = light.height();
    gbuffer.light = ScalarImage(gbuffer.width, gbuffer.height, -1.0f);
    gbuffer.objectId = IdImage(gbuffer.width, gbuffer.height);
    for (std::size_t i = 0; i < light.pixelCount(); ++i) {
        const float value = light.pixels()[i];
        const std::uint16_t object = ids ? ids->pixels()[i] : std::uint16_t(1);
        if (object == 0 || !std::isfinite(value) || value < 0) continue;
        gbuffer.light.pixels()[i] = std::min(value, 1.0f);
        gbuffer.objectId.pixels()[i] = object;
    }
    return gbuffer;
}

}  // namespace chiaro::scene
