#include "core/project/render_method.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>

namespace chiaro::project {

namespace {

Rendering renderViewAligned(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                            const Task& task) {
    std::vector<methods::ViewAlignedPaint> paints;
    for (const Paint* paint : worn) paints.push_back({&paint->levels, &paint->shown, {}});
    return {methods::renderViewAligned(gbuffer, paints, project.viewAligned, task), {}, 0};
}

nlohmann::json viewAlignedParameters(const Project& project) {
    nlohmann::json json = parametersToJson(project.levels);
    json.update(parametersToJson(project.levels.quilt));
    json.update(parametersToJson(project.viewAligned));
    return json;
}

Rendering renderImageBased(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                           const Task& task) {
    methods::SampleTextures textures;
    std::vector<const gradient::Gradient*> gradients;
    for (const Paint* paint : worn) {
        textures.push_back(&paint->separation.texture);
        gradients.push_back(&paint->shown);
    }
    const auto begin = std::chrono::steady_clock::now();
    const methods::ImageBasedTexture texture =
        methods::synthesizeImageBased(gbuffer, textures, project.imageBased, task.part(0, 0.9));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return {methods::shadeImageBased(gbuffer, gradients, texture, task.part(0.9, 1)), texture.report,
            seconds};
}

nlohmann::json imageBasedParameters(const Project& project) {
    nlohmann::json json = parametersToJson(project.imageBased);
    json.update(parametersToJson(project.imageBased.quilt));
    return json;
}

}  // namespace

std::span<const RenderMethod> renderMethods() {
    static const RenderMethod methods[] = {
        {"image-based", "Image-based", false, true, renderImageBased, imageBasedParameters},
        {"view-aligned", "View-aligned", true, false, renderViewAligned, viewAlignedParameters},
    };
    return methods;
}

const RenderMethod* findRenderMethod(std::string_view key) {
    const auto methods = renderMethods();
    const auto found = std::ranges::find(methods, key, &RenderMethod::key);
    return found == methods.end() ? nullptr : &*found;
}

const RenderMethod& renderMethod(std::string_view key) {
    if (const RenderMethod* method = findRenderMethod(key)) return *method;
    std::vector<std::string> keys;
    for (const RenderMethod& method : renderMethods()) keys.push_back(method.key);
    throw Error("method", fmt::format("is \"{}\"", key), fmt::format("choose {}", fmt::join(keys, " or ")));
}

}  // namespace chiaro::project
