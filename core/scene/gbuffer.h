#pragma once

#include "core/base/image.h"
#include "core/base/task.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiaro::scene {

/// What one ray met.
struct SurfaceSample {
    std::uint16_t object = 0;  ///< 1.., 0 is nothing
    float light = 0;           ///< L in [0, 1]
    friend bool operator==(const SurfaceSample&, const SurfaceSample&) = default;
};

/// What each pixel's centre (x + 0.5, y + 0.5) sees (§4.1: guide and object ids), and finer samples where a
/// silhouette, an object border or a sudden change of light crosses a pixel.
struct GBuffer {
    int width = 0;
    int height = 0;
    glm::vec3 eye{0};               ///< where the view was cast from, world space
    ScalarImage light;              ///< L in [0, 1], -1 outside
    IdImage objectId;               ///< 0 outside, 1.. the object
    Image<std::uint32_t> faceId;    ///< index in the object's mesh; 0xFFFFFFFF outside
    Image<glm::vec2> barycentrics;  ///< weights of the triangle's second and third vertex
    ScalarImage depth;              ///< distance along the view direction, world units; infinity outside
    ColorImage normal;  ///< world space, unit, interpolated, on the side of the face that the eye sees and
                        ///< never turned away from the eye; 0 outside

    /// Pixels that several surfaces share, in raster order, each with `samplesPerEdge` samples on a fixed
    /// pattern. A final picture averages the shaded samples there; elsewhere the centre speaks for the whole
    /// pixel.
    static constexpr int samplesPerEdge = 16;
    std::vector<std::uint32_t> edgePixels;   ///< y * width + x
    std::vector<SurfaceSample> edgeSamples;  ///< edgePixels.size() * samplesPerEdge
};

/// The scene's acceleration structure (Embree). Immutable once built; casts from any thread.
class RayScene {
public:
    /// Objects that are not visible are left out; ids count them nevertheless. Throws Cancelled; Error when
    /// there is not enough memory.
    explicit RayScene(const Scene& scene, const Task& task = {});
    /// The same surfaces, which keep this from each other of the light; costs nothing.
    RayScene with(const OcclusionParams& occlusion) const;

    /// At first those of the scene that it was built from.
    const OcclusionParams& occlusion() const { return m_occlusion; }

    struct Impl;
    const Impl& impl() const { return *m_impl; }

private:
    std::shared_ptr<const Impl> m_impl;
    OcclusionParams m_occlusion;
};

/// Casts the G-buffer of a view, 1..16384 pixels a side, tiles in parallel; the bytes do not depend on the
/// threads. Lights may differ from those the RayScene was built with; shadows and ambient occlusion are
/// the RayScene's. A back side is lit with the flipped normal. Throws Cancelled.
GBuffer castGBuffer(const RayScene& rays, const std::vector<Light>& lights, const Camera& camera, int width,
                    int height, const Task& task = {});

}  // namespace chiaro::scene
