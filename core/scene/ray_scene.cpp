#include "core/scene/ray_scene.h"

#include "core/base/error.h"

#include <array>

namespace chiaro::scene {

namespace {

bool takesPart(const Object& object) {
    return object.visible && object.mesh && !object.mesh->triangles.empty();
}

/// The nearest hit so far of each ray of a packet, for settling ties.
struct Nearest {
    RTCIntersectContext context;  // first: Embree hands back a pointer to it
    std::array<float, packetSize> depth;
    std::array<std::uint64_t, packetSize> face;  ///< object << 32 | face
};

/// Called for each hit no farther than the nearest so far; turns down those that lose a tie.
void settleTies(const RTCFilterFunctionNArguments* arguments) {
    auto& nearest = *reinterpret_cast<Nearest*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const unsigned ray = RTCRayN_id(arguments->ray, arguments->N, i);
        const float depth = RTCRayN_tfar(arguments->ray, arguments->N, i);
        const std::uint64_t face = std::uint64_t(RTCHitN_geomID(arguments->hit, arguments->N, i)) << 32 |
                                   RTCHitN_primID(arguments->hit, arguments->N, i);
        if (depth == nearest.depth[ray] && face > nearest.face[ray]) {
            arguments->valid[i] = 0;
            continue;
        }
        nearest.depth[ray] = depth;
        nearest.face[ray] = face;
    }
}

std::vector<glm::vec3> worldNormals(const Object& object) {
    const glm::dmat3 linear(glm::dmat4(object.transform));
    // The cofactor matrix: the inverse transpose up to scale, also defined for a flattened object.
    const glm::dmat3 turn(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                          glm::cross(linear[0], linear[1]));
    const double side = glm::determinant(linear) < 0 ? -1 : 1;
    std::vector<glm::vec3> normals;
    normals.reserve(object.mesh->normals.size());
    for (const glm::vec3& normal : object.mesh->normals) {
        const glm::dvec3 turned = turn * glm::dvec3(normal) * side;
        const double length = glm::length(turned);
        normals.push_back(length > 0 ? glm::vec3(turned / length) : normal);
    }
    return normals;
}

void attach(RayScene::Impl& rays, const Object& object, unsigned id) {
    const Mesh& mesh = *object.mesh;
    RTCGeometry geometry = rtcNewGeometry(rays.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    if (vertices != nullptr) {
        const glm::dmat4 transform(object.transform);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::dvec3 world(transform * glm::dvec4(mesh.positions[i], 1));
            vertices[i] = glm::vec3((world - rays.center) / rays.unit);
        }
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles.data(), 0, sizeof(Triangle), mesh.triangles.size());
        rtcSetGeometryIntersectFilterFunction(geometry, settleTies);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(rays.scene, geometry, id);
    }
    rtcReleaseGeometry(geometry);
}

}  // namespace

// What is made by then is released when memory fails in here: the other constructor is done.
RayScene::Impl::Impl(const Scene& source, const Task& task) : Impl() {
    const Bounds bounds = boundsOf(source);
    center = glm::dvec3(bounds.center());
    if (bounds.radius > 0 && std::isfinite(bounds.radius)) unit = double(bounds.radius);
    device = rtcNewDevice(nullptr);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through an edge between two faces
    rtcSetSceneProgressMonitorFunction(
        scene,
        [](void* waiting, double fraction) {
            const Task& building = *static_cast<const Task*>(waiting);
            building.report(fraction);
            return !building.cancelled();
        },
        const_cast<Task*>(&task));
    objects.resize(source.objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (task.cancelled()) break;
        if (!takesPart(source.objects[i])) continue;
        objects[i] = {source.objects[i].mesh, worldNormals(source.objects[i])};
        attach(*this, source.objects[i], unsigned(i));
    }
    if (!task.cancelled()) rtcCommitScene(scene);
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
}

RayScene::Impl::~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
}

RayScene::RayScene(const Scene& scene, const Task& task)
    : m_impl(std::make_shared<const Impl>(scene, task)), m_occlusion(scene.occlusion) {
    task.checkpoint();
    if (const RTCError error = rtcGetDeviceError(m_impl->device); error != RTC_ERROR_NONE)
        throw Error("mesh", "is too large to be prepared for drawing", "a smaller one would fit in memory");
}

RayScene RayScene::with(const OcclusionParams& occlusion) const {
    RayScene other(*this);
    other.m_occlusion = occlusion;
    return other;
}

RayCaster::RayCaster(const RayScene::Impl& rays, const Camera& camera, int width, int height)
    : m_rays(rays),
      m_eye(camera.position()),
      m_localEye((glm::dvec3(camera.position()) - rays.center) / rays.unit),
      m_basis(camera.basis()),
      m_near(float(double(camera.nearPlane()) / rays.unit)),
      m_far(float(double(camera.farPlane()) / rays.unit)) {
    const glm::vec2 extent = camera.halfExtent(width, height);
    m_corner = glm::vec2(-extent.x, extent.y);
    m_step = 2.0f * extent / glm::vec2(float(width), float(height));
}

glm::vec3 RayCaster::direction(glm::vec2 position) const {
    return m_basis[0] * (m_corner.x + position.x * m_step.x) +
           m_basis[1] * (m_corner.y - position.y * m_step.y) - m_basis[2];
}

void RayCaster::cast(std::span<const glm::vec2> positions, std::span<Hit> hits) const {
    alignas(64) std::array<int, packetSize> valid{};
    alignas(64) RTCRayHit16 packet;
    alignas(64) Nearest nearest;
    nearest.depth.fill(std::numeric_limits<float>::infinity());
    for (unsigned i = 0; i < packetSize; ++i) {
        valid[i] = i < positions.size() ? -1 : 0;
        const glm::vec3 ray = direction(positions[std::min<std::size_t>(i, positions.size() - 1)]);
        packet.ray.org_x[i] = m_localEye.x;
        packet.ray.org_y[i] = m_localEye.y;
        packet.ray.org_z[i] = m_localEye.z;
        packet.ray.dir_x[i] = ray.x;
        packet.ray.dir_y[i] = ray.y;
        packet.ray.dir_z[i] = ray.z;
        packet.ray.tnear[i] = m_near;  // the direction advances by 1 along the view: t is depth
        packet.ray.tfar[i] = m_far;
        packet.ray.time[i] = 0;
        packet.ray.mask[i] = 0xFFFFFFFF;
        packet.ray.id[i] = i;
        packet.ray.flags[i] = 0;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcInitIntersectContext(&nearest.context);
    nearest.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), m_rays.scene, &nearest.context, &packet);
    for (unsigned i = 0; i < positions.size(); ++i) {
        Hit& hit = hits[i] = Hit{};
        if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        hit.object = std::uint16_t(packet.hit.geomID[i] + 1);
        hit.face = packet.hit.primID[i];
        hit.barycentrics = {packet.hit.u[i], packet.hit.v[i]};
        hit.depth = float(double(packet.ray.tfar[i]) * m_rays.unit);
        const glm::vec3 normal(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
        const glm::vec3 ray(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
        const float length = glm::length(normal);
        hit.faceNormal = length > 0 ? normal / length : -glm::normalize(ray);
        if (glm::dot(hit.faceNormal, ray) > 0) hit.faceNormal = -hit.faceNormal;
    }
}

glm::vec3 RayCaster::normal(const Hit& hit, glm::vec2 position) const {
    const RayObject& object = m_rays.objects[hit.object - 1u];
    const Triangle& triangle = object.mesh->triangles[hit.face];
    const glm::vec2 weights = hit.barycentrics;
    glm::vec3 normal = object.normals[triangle[0]] * (1 - weights.x - weights.y) +
                       object.normals[triangle[1]] * weights.x + object.normals[triangle[2]] * weights.y;
    const float length = glm::length(normal);
    if (!(length > 1e-6f)) return hit.faceNormal;
    normal /= length;
    // The face tells which side is seen, so that meshes whose winding and normals disagree are lit all the
    // same.
    if (glm::dot(normal, hit.faceNormal) < 0) normal = -normal;
    const glm::vec3 toEye = -glm::normalize(direction(position));
    const float facing = glm::dot(normal, toEye);
    return facing >= 0 ? normal : glm::normalize(normal - facing * toEye);
}

}  // namespace chiaro::scene
