#include "core/views/occluders.h"

#include "core/base/error.h"

#include <embree3/rtcore.h>

#include <utility>

namespace chiaro::views {

struct Occluders::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> faces;  ///< of the surface, for each of Embree's

    ~Impl() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

namespace {

/// What the filter knows of the ray that met a face.
struct Probing {
    RTCIntersectContext context;  // first: Embree hands back a pointer to it
    const Occluders* occluders;
    const std::vector<std::uint32_t>* faces;
    std::uint32_t face;
    glm::dvec3 towardsEye;
};

/// Turns down what doesn't hide: the face itself, its neighbours, and back sides where those aren't drawn.
void rejectNeighbours(const RTCFilterFunctionNArguments* arguments) {
    const auto& probing = *reinterpret_cast<const Probing*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const std::uint32_t other = (*probing.faces)[RTCHitN_primID(arguments->hit, arguments->N, i)];
        const Surface& surface = probing.occluders->surface();
        if (surface.adjacent(probing.face, other) ||
            !probing.occluders->hides(other, glm::dot(surface.normal(other), probing.towardsEye)))
            arguments->valid[i] = 0;
    }
}

void attach(Occluders::Impl& impl, const Surface& surface) {
    const scene::Mesh& mesh = surface.mesh();
    RTCGeometry geometry = rtcNewGeometry(impl.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree works in single precision with tolerances around 1.
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    auto* triangles = static_cast<scene::Triangle*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(scene::Triangle), impl.faces.size()));
    if (vertices != nullptr && triangles != nullptr) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            vertices[i] = glm::vec3((glm::dvec3(mesh.positions[i]) - surface.center()) / surface.radius());
        for (std::size_t i = 0; i < impl.faces.size(); ++i) triangles[i] = mesh.triangles[impl.faces[i]];
        rtcSetGeometryOccludedFilterFunction(geometry, rejectNeighbours);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(impl.scene, geometry);
    }
    rtcReleaseGeometry(geometry);
}

}  // namespace

Occluders::Occluders(const Surface& surface, FaceMask drawn, Sides sides, double minimumFacing)
    : m_surface(surface),
      m_drawn(std::move(drawn)),
      m_sides(sides),
      m_minimumFacing(minimumFacing),
      m_impl(std::make_unique<Impl>()) {
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (!(surface.area(face) > 0)) m_drawn[face] = 0;
        if (m_drawn[face] != 0) m_impl->faces.push_back(face);
    }
    if (m_impl->faces.empty()) return;
    m_impl->device = rtcNewDevice(nullptr);
    m_impl->scene = rtcNewScene(m_impl->device);
    rtcSetSceneFlags(m_impl->scene, RTC_SCENE_FLAG_ROBUST);
    attach(*m_impl, surface);
    rtcCommitScene(m_impl->scene);
    if (rtcGetDeviceError(m_impl->device) != RTC_ERROR_NONE)
        throw Error("mesh", "is too large for views to be planned", "a smaller one would fit in memory");
}

Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;

bool Occluders::hidden(std::uint32_t face, const glm::dvec3& point, const glm::dvec3& towardsEye,
                       double facing, double distance) const {
    if (m_impl->faces.empty()) return false;
    const double unit = m_surface.radius();
    const glm::vec3 origin((point - m_surface.center()) / unit);
    const glm::vec3 direction(towardsEye);
    constexpr double rounding = 2e-6;  // of the ray's single precision
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = float(slack(facing) / unit + rounding);
    ray.tfar = float(distance / unit);
    ray.mask = 0xFFFFFFFF;
    Probing probing{{}, this, &m_impl->faces, face, towardsEye};
    rtcInitIntersectContext(&probing.context);
    rtcOccluded1(m_impl->scene, &probing.context, &ray);
    return ray.tfar < 0;
}

bool Occluders::hidden(std::uint32_t face, const glm::dvec3& towardsEye, double facing) const {
    for (int probe = 0; probe < probeCount; ++probe)
        if (hidden(face, probeOf(m_surface, face, probe), towardsEye, facing,
                   std::numeric_limits<double>::infinity()))
            return true;
    return false;
}

glm::dvec3 probeOf(const Surface& surface, std::uint32_t face, int probe) {
    const glm::dvec3 centroid = surface.centroid(face);
    if (probe == 0) return centroid;
    constexpr double towardsCorner = 0.85;
    return glm::mix(centroid, surface.corner(face, std::size_t(probe - 1)), towardsCorner);
}

}  // namespace chiaro::views
