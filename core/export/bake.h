#pragma once

#include "core/base/image.h"
#include "core/base/task.h"
#include "core/export/atlas.h"

#include <functional>

namespace chiaro::exporting {

/// Three channels of 8 bits, display-referred.
using ByteImage = Image<glm::u8vec3>;

/// The colour of a place on a face, display-referred in [0, 1]; barycentrics weigh its second and third
/// corner. Called from several threads.
using PlaceColor = std::function<glm::vec3(std::size_t object, std::uint32_t face, glm::vec2 barycentrics)>;

struct BakeParams {
    int samples = 2;  ///< along each side of a texel, 1..8; their mean is the texel's colour
    bool dilate =
        true;  ///< let charts grow until they meet, so that no mip level shows anything between them
};

/// Paints an atlas. A texel is divided into samples x samples cells; each of which a face covers a part has
/// the colour of the covered place nearest to its middle, and a texel the mean of its cells. Texels without
/// any take the colour of the nearest one that has (or stay black). Rows in parallel; the bytes do not depend
/// on the threads. Throws Cancelled.
ByteImage bakeAtlas(const Atlas& atlas, const PlaceColor& color, const BakeParams& params,
                    const Task& task = {});

/// Gives every pixel that is not covered (0) the colour of the nearest one that is; nothing when none is.
void dilate(ByteImage& picture, const Image<std::uint8_t>& covered);

/// Mean colours of the surroundings of an object's vertices, for files that hold a colour a vertex. `color`
/// is of this object's faces.
std::vector<glm::u8vec3> vertexColors(const scene::Mesh& mesh,
                                      const std::function<glm::vec3(std::uint32_t, glm::vec2)>& color,
                                      const Task& task = {});

}  // namespace chiaro::exporting
