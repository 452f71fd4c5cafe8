#include "core/project/render_method.h"

#include "core/base/error.h"
#include "core/project/render_image_based.h"
#include "core/project/render_view_aligned.h"
#include "core/project/render_view_dependent.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::project {

std::span<const RenderMethod> renderMethods() {
    static const RenderMethod methods[] = {
        {"image-based", "Image-based", false, false, true, renderImageBased, animateImageBased,
         imageBasedParameters},
        {"view-aligned", "View-aligned", true, false, false, renderViewAligned, animateViewAligned,
         viewAlignedParameters},
        {"view-dependent", "View-dependent", false, true, false, renderViewDependent, animateViewDependent,
         viewDependentParameters},
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
