#pragma once

#include "core/metrics/frame.h"
#include "core/project/pipeline.h"
#include "core/scene/path.h"

namespace chiaro::project {

/// The report's table (§5): what the methods do to one and the same animation.
struct ComparisonParams {
    int width = 512;  ///< of every frame, pixels
    int height = 512;
    int frames = 8;  ///< of the path, from its first on; at least 2
    int seeds = 5;   ///< syntheses and draws of pixels, from the project's seed on
    metrics::MeasureParams measure;
};

/// Means over pixels, and their errors, which combine the spread over pixels and that over seeds. The
/// temporal ones tell how much changes from the frame before.
struct MeasuredErrors {
    metrics::Estimate similarity, shading, shadingSquared, temporalImage, temporalObject;
};

/// One column of the table: the means over all frames and seeds.
struct MethodMeasure : MeasuredErrors {
    std::string method;                    ///< key of a RenderMethod
    std::vector<MeasuredErrors> perFrame;  ///< over seeds; a count of 0 where nothing could be measured, as
                                           ///< the temporal ones of the first
    std::vector<ColorAlphaImage> frames;   ///< of the first seed
};

/// The project with its methods as the report animates them (§4.1, §4.2), for a comparison with its table.
/// Image-based frames stay close to the frame before, each a synthesis of its own; and the 3D texture keeps
/// its scale. What this program adds by default changes the order: frames blended from two keyframes lose
/// contrast, so that they resemble the sample less than the 3D texture's do, and a 3D texture that grows with
/// its object moves on the screen as the surface does.
Project animatedAsReported(Project project);

/// Paints the animation by every method and measures it, each object against the sample that it wears, in
/// its colours of now. Throws Error, also when no block of the frames can be measured; Cancelled.
std::vector<MethodMeasure> compareMethods(const Project& project, const scene::Scene& scene,
                                          const scene::Path& path, const ComparisonParams& params,
                                          const Task& task = {}, const TextureCache* cache = nullptr);

}  // namespace chiaro::project
