#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"
#include "core/base/task.h"
#include "core/synthesis/quilting.h"

#include <vector>

namespace chiaro::synthesis {

enum class Tiling {
    Mask,
    Seam
};  ///< the report's circular mask, or wrap-around quilting with a seam cut (§4.2)
enum class LevelBase {
    Section,
    Gradient
};  ///< what is subtracted from the strip: a section's average, or G(u(x))

/// QuiltTask::variety of levels: their sections are narrow, and the same few strokes would come back in rows.
inline constexpr int levelVariety = 4;

struct LevelParams {
    int count = 8;   ///< sections of the strip, 2..32
    int size = 512;  ///< a level's side n, 64..2048 px
    Tiling tiling = Tiling::Seam;
    LevelBase base = LevelBase::Gradient;
    QuiltParams quilt;
    static const ParameterTable<LevelParams>& table();  ///< all but `quilt`
    friend bool operator==(const LevelParams&, const LevelParams&) = default;
};

/// The slices of the 3D texture (§4.2), darkest first: square difference images in [-1, 1] that tile without
/// a seam.
struct LevelStack {
    std::vector<ColorImage> levels;
    QuiltReport report;  ///< over all levels
};

/// What one level is quilted from.
struct LevelSource {
    ColorImage texture;  ///< a section of the strip less its base, [-1, 1]
    QuiltParams quilt;   ///< with a seed of its own
};

/// The sources of all levels, darkest first; see makeLevels, which quilts one square from each. Throws Error
/// as it does.
std::vector<LevelSource> levelSources(const ColorImage& strip, const std::vector<glm::vec3>& gradient,
                                      const LevelParams& params);

/// Quilts a level from each section of the strip. `strip` is W x H in [0, 1]; `gradient` its W colours
/// G(u(x)). A section narrower than a block and a half is widened about its centre to that, as far as the
/// strip goes; a block that doesn't fit even so is made smaller (see fittedBlock), so that every strip gives
/// levels. Levels are made in parallel; the bytes depend only on the inputs, never on the threads. Throws
/// Error when a parameter is out of range or the gradient isn't as long as the strip, Cancelled when the task
/// was.
LevelStack makeLevels(const ColorImage& strip, const std::vector<glm::vec3>& gradient,
                      const LevelParams& params, const Task& task = {});

}  // namespace chiaro::synthesis
