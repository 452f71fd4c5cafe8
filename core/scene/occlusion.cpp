#include "core/scene/occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiaro::scene {

namespace {

/// Off the surface by as much as the rounding of its points, in scene radii.
constexpr float lift = 2e-4f;

/// The digits of a number turned around the point: evenly spread for consecutive numbers.
float radicalInverse(unsigned number, unsigned base) {
    float result = 0, share = 1.0f / float(base);
    for (; number > 0; number /= base, share /= float(base)) result += float(number % base) * share;
    return result;
}

/// Two directions that stand on the normal and each other, steady as the normal turns.
glm::mat3 frameAround(glm::vec3 z) {
    const float sign = std::copysign(1.0f, z.z);
    const float a = -1 / (sign + z.z);
    const float b = z.x * z.y * a;
    return {{1 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace

const ParameterTable<OcclusionParams>& OcclusionParams::table() {
    static const auto made =
        ParameterTable<OcclusionParams>()
            .add(&OcclusionParams::shadows,
                 ParameterSpec::boolean("shadows", "Shadows", "Surfaces cast shadows on each other"))
            .add(&OcclusionParams::ambient,
                 ParameterSpec::real("ambient-occlusion", "Ambient occlusion", "", 0, 1, 0.05,
                                     "How much darker corners and contacts are painted; 0 is off"))
            .add(&OcclusionParams::ambientRadius,
                 ParameterSpec::real("ambient-radius", "Occlusion radius", "%", 1, 200, 1,
                                     "How far ambient occlusion looks around, of the scene's radius"));
    return made;
}

OcclusionCaster::OcclusionCaster(const RayScene::Impl& rays, const OcclusionParams& params,
                                 const std::vector<Light>& lights)
    : m_rays(rays), m_params(params), m_lights(lights) {
    for (unsigned i = 0; i < ambientRays; ++i) {
        const float share = (float(i) + 0.5f) / float(ambientRays);
        const float angle = 2 * std::numbers::pi_v<float> * radicalInverse(i + 1, 2);
        const float radius = std::sqrt(share);
        m_directions[i] = {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - share)};
        // Rays of every length up to the radius: together they fade with the distance.
        m_reaches[i] = float(params.ambientRadius / 100) * (0.02f + 0.98f * radicalInverse(i + 1, 3));
    }
}

glm::vec3 OcclusionCaster::origin(const Point& point) const {
    const glm::vec3 local((glm::dvec3(point.position) - m_rays.center) / m_rays.unit);
    return local + point.faceNormal * lift;
}

bool OcclusionCaster::isInShadow(const Point& point, const Light& light) const {
    const glm::vec3 from = origin(point);
    const glm::vec3 way = light.direction(point.position);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{};
    ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
    ray.dir_x = way.x, ray.dir_y = way.y, ray.dir_z = way.z;
    ray.tfar = float(double(light.distance(point.position)) / m_rays.unit);
    ray.mask = ~0u;
    rtcOccluded1(m_rays.scene, &context, &ray);
    return ray.tfar < 0;
}

float OcclusionCaster::light(const Point& point) const {
    if (!m_params.shadows) return lightValue(m_lights, point.position, point.normal);
    float sum = 0;
    for (const Light& light : m_lights) {
        if (!light.visible) continue;
        float cosine = glm::dot(point.normal, light.direction(point.position));
        if (cosine > 0 && isInShadow(point, light)) cosine = 0;
        sum += light.shine(cosine);
    }
    return std::clamp(sum, 0.0f, 1.0f);
}

float OcclusionCaster::openness(const Point& point) const {
    if (m_params.ambient == 0) return 1;
    const glm::vec3 from = origin(point);
    const glm::mat3 frame = frameAround(point.normal);
    int closed = 0;
    for (int first = 0; first < ambientRays; first += packetSize) {
        alignas(64) std::array<int, packetSize> valid;
        alignas(64) RTCRay16 rays{};
        for (int i = 0; i < packetSize; ++i) {
            const auto index = std::size_t(first + i);
            const glm::vec3 way = frame * m_directions[index];
            // Below the face itself there is nothing to see: a coarse mesh would shade its own facets.
            valid[std::size_t(i)] = glm::dot(way, point.faceNormal) > 0 ? -1 : 0;
            rays.org_x[i] = from.x, rays.org_y[i] = from.y, rays.org_z[i] = from.z;
            rays.dir_x[i] = way.x, rays.dir_y[i] = way.y, rays.dir_z[i] = way.z;
            rays.tfar[i] = m_reaches[index];
            rays.mask[i] = ~0u;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded16(valid.data(), m_rays.scene, &context, &rays);
        for (int i = 0; i < packetSize; ++i) closed += valid[std::size_t(i)] != 0 && rays.tfar[i] < 0;
    }
    return 1 - float(m_params.ambient) * float(closed) / float(ambientRays);
}

}  // namespace chiaro::scene
