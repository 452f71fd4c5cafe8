#include "widgets/viewport/view_state.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

bool samePose(const methods::ObjectView& a, const methods::ObjectView& b) {
    return a.objectToView == b.objectToView && a.projection == b.projection && a.width == b.width &&
           a.height == b.height;
}

const std::string& drawn(const std::string& key) {
    const auto methods = drawnMethods();
    return std::ranges::find(methods, key) != methods.end() ? key : methods.front();
}

ViewportPaint grey() {
    return {nullptr, {glm::vec3(0.12f), glm::vec3(0.92f)}};
}

}  // namespace

bool isDrawn(const scene::Object& object) {
    return object.visible && object.mesh && !object.mesh->triangles.empty();
}

std::span<const std::string> drawnMethods() {
    static const std::vector<std::string> keys{"image-based", "view-aligned", "view-dependent"};
    return keys;
}

ViewState::ViewState() : m_method("view-aligned") {}

void ViewState::setMethod(const std::string& key) {
    m_method = drawn(key);
}

void ViewState::setComposition(Composition composition) {
    for (std::string& method : composition.methods) method = drawn(method);
    m_composition = std::move(composition);
}

std::vector<std::string> ViewState::shownMethods() const {
    const std::size_t count = m_composition.shownCount();
    if (count == 1) return {m_method};
    const auto& methods = m_composition.methods;
    return {methods.begin(), methods.begin() + std::ptrdiff_t(count)};
}

bool ViewState::shows(const std::string& method) const {
    const std::vector<std::string> shown = shownMethods();
    return std::ranges::find(shown, method) != shown.end();
}

void ViewState::setScene(const scene::Scene& scene) {
    std::vector<methods::TexturePlacement> placements(scene.objects.size());
    std::vector<std::optional<methods::ObjectView>> seen(scene.objects.size());
    std::multimap<std::pair<const scene::Mesh*, std::string>, std::size_t> known;
    for (std::size_t i = 0; i < m_scene.objects.size(); ++i)
        known.emplace(std::pair(m_scene.objects[i].mesh.get(), m_scene.objects[i].name), i);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const auto before = known.find(std::pair(scene.objects[i].mesh.get(), scene.objects[i].name));
        if (before == known.end()) continue;
        placements[i] = m_placements[before->second];
        seen[i] = m_seen[before->second];
        known.erase(before);
    }
    m_scene = scene;
    m_placements = std::move(placements);
    m_seen = std::move(seen);
}

const ViewportPaint& ViewState::paint(int sample) const {
    static const ViewportPaint unpainted = grey();
    const auto found = m_paints.find(sample);
    return found == m_paints.end() ? unpainted : found->second;
}

void ViewState::setPaint(int sample, ViewportPaint paint) {
    if (paint.gradient.empty()) paint.gradient = grey().gradient;
    m_paints[sample] = std::move(paint);
}

void ViewState::setGradient(int sample, const gradient::Gradient& gradient) {
    setPaint(sample, {paint(sample).levels, gradient});
}

std::shared_ptr<const methods::PaintedObject> ViewState::paintedObject(std::size_t object) const {
    if (object >= m_paintedObjects.size() || !m_paintedObjects[object]) return nullptr;
    const bool isOfMesh =
        &m_paintedObjects[object]->planned->surface.mesh() == m_scene.objects[object].mesh.get();
    return isOfMesh ? m_paintedObjects[object] : nullptr;
}

methods::TexturePlacement ViewState::followed(std::size_t object, const methods::ObjectView& now) const {
    methods::ObjectView before = *m_seen[object];
    methods::TexturePlacement placement = m_placements[object];
    const scene::Mesh& mesh = *m_scene.objects[object].mesh;
    if (before.width != now.width || before.height != now.height) {
        methods::ObjectView resized = before;
        resized.projection = m_seenCamera.projection(now.width, now.height);
        resized.width = now.width;
        resized.height = now.height;
        methods::ViewAlignedParams unscaled = params;
        unscaled.followZoom = false;
        placement.offset = methods::follow(placement, mesh, before, resized, unscaled).offset;
        before = resized;
    }
    return samePose(before, now) ? placement : methods::follow(placement, mesh, before, now, params);
}

void ViewState::follow(QSize pixels) {
    if (pixels.isEmpty()) return;
    const glm::mat4 view = camera.view();
    const glm::mat4 projection = camera.projection(pixels.width(), pixels.height());
    for (std::size_t i = 0; i < m_scene.objects.size(); ++i) {
        const methods::ObjectView now{view * m_scene.objects[i].transform, projection, pixels.width(),
                                      pixels.height()};
        if (!m_scene.objects[i].mesh) continue;
        if (m_seen[i] && !samePose(*m_seen[i], now)) m_placements[i] = followed(i, now);
        m_seen[i] = now;
    }
    m_seenCamera = camera;
}

std::vector<methods::TexturePlacement> ViewState::textureMotions(const ViewTexture& texture,
                                                                 QSize pixels) const {
    return texture.motions(m_scene, camera, pixels.width(), pixels.height());
}

}  // namespace chiaro::widgets
