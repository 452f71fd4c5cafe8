#include "app/frame_textures.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "app/meshes.h"
#include "app/paints.h"
#include "core/base/hash.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 80;
const char* const slot = "frame texture";

/// A draft is to be seen in the first frames of a drag: its guide is of half the size, which costs a quarter
/// of the rays, and its search is core's draft.
constexpr int draftStep = 2;
methods::ImageBasedParams draftOf(methods::ImageBasedParams params) {
    params.draft = true;
    return params;
}

template <class Params>
void addParams(Hasher& hasher, const Params& params) {
    for (double value : Params::table().values(params)) hasher.add(value);
}

void addCamera(Hasher& hasher, const scene::Camera& camera) {
    for (float value : {camera.azimuth, camera.elevation, camera.distance, camera.target.x, camera.target.y,
                        camera.target.z, camera.radius, camera.fieldOfView})
        hasher.add(value);
}

void addLights(Hasher& hasher, const std::vector<scene::Light>& lights) {
    hasher.add(lights.size());
    for (const scene::Light& light : lights)
        hasher.add(light.kind)
            .add(light.vector.x)
            .add(light.vector.y)
            .add(light.vector.z)
            .add(light.intensity)
            .add(light.wrap)
            .add(light.visible);
}

/// What a draft goes by: the centres of every other pixel, each for its neighbours as well.
scene::GBuffer draftGuide(const scene::RayScene& rays, const scene::Scene& scene, const scene::Camera& camera,
                          QSize pixels, const Task& task) {
    const auto reduced = [](int size) { return (size + draftStep - 1) / draftStep; };
    const scene::GBuffer small = scene::castGBuffer(rays, scene.lights, camera, reduced(pixels.width()),
                                                    reduced(pixels.height()), task);
    scene::GBuffer guide;
    guide.width = pixels.width();
    guide.height = pixels.height();
    guide.light = ScalarImage(guide.width, guide.height);
    guide.objectId = IdImage(guide.width, guide.height);
    for (int y = 0; y < guide.height; ++y)
        for (int x = 0; x < guide.width; ++x) {
            guide.light(x, y) = small.light(x / draftStep, y / draftStep);
            guide.objectId(x, y) = small.objectId(x / draftStep, y / draftStep);
        }
    return guide;
}

}  // namespace

/// A snapshot of all that a texture is made from.
struct FrameTextures::Inputs {
    scene::Scene scene;
    std::uint64_t sceneMeshes = 0;
    std::vector<std::shared_ptr<const ColorImage>> textures;  ///< one an object; null where it wears none
    std::vector<std::uint64_t> textureKeys;
    scene::Camera camera;
    QSize pixels;
    methods::ImageBasedParams params;
    Rays rays;  ///< null: to be built
};

struct FrameTextures::Made {
    Rays rays;
    std::shared_ptr<const widgets::ViewTexture> texture;
};

FrameTextures::FrameTextures(Document& document, JobRunner& jobs, Memo& memo, Paints& paints, Meshes& meshes,
                             QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_memo(memo), m_paints(paints), m_meshes(meshes) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &FrameTextures::refresh);
    connect(&document, &Document::changed, this, &FrameTextures::applyChange);
    connect(&paints, &Paints::separationChanged, this, &FrameTextures::refresh);
    connect(&meshes, &Meshes::sceneChanged, this, &FrameTextures::refresh);
    connect(&jobs, &JobRunner::failed, this, &FrameTextures::refresh);  // it may have been waited for
}

void FrameTextures::setView(const scene::Camera& camera, QSize pixels) {
    m_camera = camera;
    m_pixels = pixels;
    refresh();
}

void FrameTextures::setLights(const std::vector<scene::Light>& lights) {
    if (m_lights == lights) return;
    m_lights = lights;
    refresh();
}

void FrameTextures::retry() {
    m_givenUp.clear();
    refresh();
}

void FrameTextures::applyChange(Change change) {
    using Kind = Change::Kind;
    switch (change.kind) {
        case Kind::Everything:
            m_givenUp.clear();
            return refresh();
        case Kind::Samples:
        case Kind::Lights:
        case Kind::Method:
        case Kind::ImageBased:
            return refresh();
        case Kind::Strip:     // the separation that comes of it
        case Kind::Gradient:  // tells itself
        case Kind::Mesh:      // and so does the scene
        case Kind::Objects:
        case Kind::Occlusion:
        case Kind::Animation:
        case Kind::Recoloring:  // over the same texture
        case Kind::Levels:
        case Kind::ViewAligned:
        case Kind::Coherence:
        case Kind::ViewDependent:
        case Kind::Views:
        case Kind::PlacedViews:
            return;
    }
}

FrameTextures::Inputs FrameTextures::inputs() const {
    Inputs inputs;
    inputs.scene = m_meshes.scene();
    if (m_lights) inputs.scene.lights = *m_lights;
    inputs.sceneMeshes = m_meshes.contentKey();
    inputs.camera = m_camera;
    inputs.pixels = m_pixels;
    inputs.params = m_document.project().imageBased;
    const int samples = int(m_document.project().samples.size());
    for (const scene::Object& object : inputs.scene.objects) {
        const bool known = object.sample < samples && m_paints.state(object.sample).separated;
        const Paints::State* state = known ? &m_paints.state(object.sample) : nullptr;
        inputs.textures.push_back(state ? state->separated->texture : nullptr);
        inputs.textureKeys.push_back(state ? state->separated->key : 0);
    }
    return inputs;
}

FrameTextures::Keys FrameTextures::keysOf(const Inputs& inputs) const {
    Keys keys;
    keys.meshes = inputs.sceneMeshes;
    Hasher geometry;
    geometry.add("geometry").add(keys.meshes).add(inputs.scene.objects.size());
    for (const scene::Object& object : inputs.scene.objects) {
        geometry.add(object.visible);
        geometry.bytes(&object.transform[0][0], sizeof object.transform);
    }
    keys.geometry = geometry.value();

    Hasher content;
    content.add("frame texture").add(keys.geometry).add(std::span<const std::uint64_t>(inputs.textureKeys));
    addParams(content, inputs.params);
    addParams(content, inputs.params.quilt);
    keys.content = content.value();

    Hasher view;
    view.add(keys.content).add(inputs.pixels.width()).add(inputs.pixels.height());
    addCamera(view, inputs.camera);
    addLights(view, inputs.scene.lights);
    addParams(view, inputs.scene.occlusion);
    keys.view = view.value();
    return keys;
}

bool FrameTextures::isWanted() const {
    return m_document.shows("image-based") && !m_pixels.isEmpty();
}

bool FrameTextures::isWaitingForPaint() const {
    const int samples = int(m_document.project().samples.size());
    for (const scene::Object& object : m_meshes.scene().objects)
        if (object.visible && object.sample < samples && m_paints.isSeparating(object.sample) &&
            !m_paints.state(object.sample).separated)
            return true;
    return false;
}

void FrameTextures::stop() {
    m_rest.stop();
    m_jobs.supersede(slot);
}

void FrameTextures::refresh() {
    Inputs now = inputs();
    const Keys keys = keysOf(now);
    const bool isPainted =
        std::ranges::any_of(now.textures, [](const auto& texture) { return texture != nullptr; });
    // The texture of other objects says nothing about these.
    if (m_texture && m_shownKeys.meshes != keys.meshes) show(nullptr, {}, false);
    if (!isWanted() || !isPainted || isWaitingForPaint()) return stop();
    if (std::exchange(m_lastView, keys.view) != keys.view) m_rest.start();

    const bool isShown = m_texture && m_shownKeys.view == keys.view;
    if (isShown && m_isFinal) return stop();
    if (auto texture = m_memo.find<widgets::ViewTexture>(keys.view)) {
        stop();
        return show(std::move(texture), keys, true);
    }
    m_isFinal = false;
    if (m_jobs.isRunning(slot)) {
        // A draft is worth finishing though the view went on meanwhile: its objects take it along.
        const bool isWorthwhile =
            m_workKeys.view == keys.view || (m_workIsDraft && m_workKeys.content == keys.content);
        if (isWorthwhile) return;
    }
    if (m_givenUp.contains(keys.view)) return m_jobs.supersede(slot);
    if (m_raysGeometry == keys.geometry) now.rays = m_rays;
    if (!isShown) return start(std::move(now), keys, true);
    if (!m_rest.isActive()) start(std::move(now), keys, false);
}

FrameTextures::Made FrameTextures::make(const Inputs& inputs, bool isDraft, const Task& task) {
    static const ColorImage unpainted(64, 64, glm::vec3(0));
    const Rays rays = inputs.rays
                          ? std::make_shared<const scene::RayScene>(inputs.rays->with(inputs.scene.occlusion))
                          : std::make_shared<const scene::RayScene>(inputs.scene, task.part(0, 0.1));
    const Task casting = task.part(0.1, 0.5);
    const scene::GBuffer gbuffer =
        isDraft ? draftGuide(*rays, inputs.scene, inputs.camera, inputs.pixels, casting)
                : scene::castGBuffer(*rays, inputs.scene.lights, inputs.camera, inputs.pixels.width(),
                                     inputs.pixels.height(), casting);
    methods::SampleTextures samples;
    for (const auto& texture : inputs.textures) samples.push_back(texture ? texture.get() : &unpainted);
    const methods::ImageBasedTexture made = methods::synthesizeImageBased(
        gbuffer, samples, isDraft ? draftOf(inputs.params) : inputs.params, task.part(0.5, 0.95));
    return {rays, std::make_shared<const widgets::ViewTexture>(widgets::viewTexture(
                      made, inputs.scene, inputs.camera, gbuffer.width, gbuffer.height, task))};
}

void FrameTextures::start(Inputs inputs, const Keys& keys, bool isDraft) {
    ++m_synthesisCount;
    if (isDraft) ++m_draftCount;
    m_workKeys = keys;
    m_workIsDraft = isDraft;
    const auto giveUp = [this, view = keys.view] { m_givenUp.insert(view); };
    m_jobs.start(
        {isDraft ? tr("Sketching the view") : tr("Synthesising the view"), slot,
         [this, giveUp](const QString& message) {
             giveUp();
             Q_EMIT m_jobs.failed(message);
         },
         giveUp},
        [inputs = std::move(inputs), isDraft](const Task& task) { return make(inputs, isDraft, task); },
        [this, keys, isDraft](Made made) { take(std::move(made), keys, isDraft); });
}

void FrameTextures::take(Made made, const Keys& keys, bool isDraft) {
    m_rays = std::move(made.rays);
    m_raysGeometry = keys.geometry;
    const std::size_t bytes = made.texture->bytes();
    if (!isDraft) m_memo.insert(keys.view, made.texture, bytes);
    show(std::move(made.texture), keys, !isDraft);
    refresh();
}

void FrameTextures::show(std::shared_ptr<const widgets::ViewTexture> texture, const Keys& keys,
                         bool isFinal) {
    m_texture = std::move(texture);
    m_shownKeys = keys;
    m_isFinal = isFinal;
    Q_EMIT textureChanged();
}

}  // namespace chiaro::app
