#include "core/project/animation.h"

#include "core/base/hash.h"
#include "core/project/render_method.h"

namespace chiaro::project {

namespace {

constexpr std::size_t keptBytes = std::size_t(1) << 30;

std::size_t bytesOf(const scene::GBuffer& gbuffer) {
    constexpr std::size_t pixel = 2 * sizeof(float) + sizeof(std::uint16_t) + sizeof(std::uint32_t) +
                                  sizeof(glm::vec2) + sizeof(glm::vec3);
    return gbuffer.light.pixelCount() * pixel + gbuffer.edgePixels.size() * sizeof(std::uint32_t) +
           gbuffer.edgeSamples.size() * sizeof(scene::SurfaceSample);
}

void addNumbers(Hasher& hasher, std::initializer_list<double> numbers) {
    for (const double number : numbers) hasher.add(number);
}

void addChannel(Hasher& hasher, const scene::Channel& channel) {
    hasher.add(channel.keys.size());
    for (const scene::Channel::Key& key : channel.keys) addNumbers(hasher, {key.frame, key.value});
}

void addPath(Hasher& hasher, const scene::Path& path) {
    addNumbers(hasher, {path.cameraTurn, path.lightTurn, path.approach, double(path.smooth)});
    for (const scene::Channel* channel : {&path.azimuth, &path.elevation, &path.distance, &path.fieldOfView})
        addChannel(hasher, *channel);
    for (const auto& axes : {path.target, path.light})
        for (const scene::Channel& channel : axes) addChannel(hasher, channel);
}

void addView(Hasher& hasher, const scene::View& view) {
    const scene::Camera& camera = view.camera;
    for (const float value : {camera.azimuth, camera.elevation, camera.distance, camera.radius,
                              camera.fieldOfView, camera.target.x, camera.target.y, camera.target.z})
        hasher.add(value);
    for (const scene::Light& light : view.lights) {
        for (const float value : {light.vector.x, light.vector.y, light.vector.z, light.intensity})
            hasher.add(value);
        hasher.add(light.wrap).add(light.kind).add(light.visible);
    }
}

}  // namespace

std::uint64_t contentHash(const Shot& shot) {
    Hasher hasher;
    for (const scene::Object& object : shot.scene.objects) {
        hasher.add(object.visible).bytes(&object.transform, sizeof object.transform);
        if (!object.mesh) continue;
        hasher.add(std::span(object.mesh->positions)).add(std::span(object.mesh->normals));
        hasher.add(std::span(object.mesh->triangles));
    }
    for (const Worn& one : shot.worn)
        hasher.add(one.paint->strip.pixels())
            .add(one.paint->separation.texture.pixels())
            .add(std::span(one.paint->shown));
    for (const ObjectSettings& object : shot.project.objects)
        for (const PlacedView& placed : object.views)
            for (const glm::vec3& vector : {placed.direction, placed.up})
                hasher.add(vector.x).add(vector.y).add(vector.z);
    for (const double value : scene::OcclusionParams::table().values(shot.scene.occlusion)) hasher.add(value);
    addView(hasher, shot.view(1));
    addPath(hasher, shot.path);
    return hasher.value();
}

scene::View Shot::view(int frame) const {
    return path.at(frame, {cameraFor(project, scene), scene.lights});
}

ShotViews::ShotViews(const Shot& shot, const Task& task) : m_shot(shot), m_rays(shot.scene, task) {}

methods::FrameView ShotViews::at(int frame, const Task& task) {
    for (auto kept = m_kept.begin(); kept != m_kept.end(); ++kept) {
        if (kept->frame != frame) continue;
        m_kept.splice(m_kept.begin(), m_kept, kept);
        return kept->view;
    }
    const scene::View view = m_shot.view(frame);
    auto gbuffer = std::make_shared<const scene::GBuffer>(
        scene::castGBuffer(m_rays, view.lights, view.camera, m_shot.width, m_shot.height, task));
    m_kept.push_front({frame, {gbuffer, view.camera}, bytesOf(*gbuffer)});
    std::size_t bytes = 0;
    for (auto kept = m_kept.begin(); kept != m_kept.end(); ++kept) {
        bytes += kept->bytes;
        if (bytes <= keptBytes || kept == m_kept.begin()) continue;
        m_kept.erase(kept, m_kept.end());
        break;
    }
    return m_kept.front().view;
}

std::unique_ptr<FramePainter> framePainter(const Shot& shot, ShotViews& views) {
    return renderMethod(shot.project.method).animate(shot, views);
}

}  // namespace chiaro::project
