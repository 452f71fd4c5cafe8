#include "app/viewport_link.h"

#include "app/document.h"
#include "app/frame_textures.h"
#include "app/meshes.h"
#include "app/object_textures.h"
#include "app/paints.h"
#include "app/playback.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::Viewport;

ViewportLink::ViewportLink(Document& document, Playback& playback, Paints& paints, Meshes& meshes,
                           FrameTextures& textures, ObjectTextures& objectTextures, Viewport& viewport,
                           QObject* parent)
    : QObject(parent),
      m_document(document),
      m_playback(playback),
      m_paints(paints),
      m_meshes(meshes),
      m_textures(textures),
      m_viewport(viewport) {
    connect(&document, &Document::changed, this, &ViewportLink::applyChange);
    connect(&meshes, &Meshes::sceneChanged, this, &ViewportLink::showScene);
    connect(&paints, &Paints::levelsChanged, this, &ViewportLink::showPaint);
    connect(&paints, &Paints::gradientChanged, this,
            [this](int sample) { m_viewport.setGradient(sample, m_paints.gradient(sample)); });
    connect(&textures, &FrameTextures::textureChanged, this,
            [this] { m_viewport.setViewTexture(m_textures.texture()); });
    connect(&objectTextures, &ObjectTextures::texturesChanged, this,
            [this, &objectTextures] { m_viewport.setPaintedObjects(objectTextures.textures()); });
    connect(&viewport, &Viewport::viewChanged, this,
            [this] { m_textures.setView(m_viewport.camera(), m_viewport.pixels()); });
    connect(&viewport, &Viewport::cameraEdited, &playback, &Playback::takeCamera);
    connect(&viewport, &Viewport::lightEdited, &playback, &Playback::takeLight);
    connect(&viewport, &Viewport::frameDrawn, &playback, &Playback::countPicture);
    connect(&playback, &Playback::viewChanged, this, &ViewportLink::showFrame);
    connect(&viewport, &Viewport::lightEditFinished, &document, &Document::finishEdit);
    applyChange({});
    showScene();
    m_viewport.setPaintedObjects(objectTextures.textures());
    m_textures.setView(m_viewport.camera(), m_viewport.pixels());
}

void ViewportLink::applyChange(Change change) {
    using Kind = Change::Kind;
    const project::Project& project = m_document.project();
    switch (change.kind) {
        case Kind::Everything:
            m_viewport.setMethod(project.method);
            m_viewport.setParams(project.viewAligned);
            m_viewport.setViewDependent(project.viewDependent);
            [[fallthrough]];
        case Kind::Samples:
            for (int sample = 0; sample < int(project.samples.size()); ++sample) showPaint(sample);
            for (int sample = int(project.samples.size()); sample < m_shownSamples; ++sample)
                m_viewport.setPaint(sample, {});
            m_shownSamples = int(project.samples.size());
            break;
        case Kind::ViewAligned:
            m_viewport.setParams(project.viewAligned);
            break;
        case Kind::ViewDependent:
            m_viewport.setViewDependent(project.viewDependent);
            break;
        case Kind::Method:
            m_viewport.setMethod(project.method);
            break;
        case Kind::ImageBased:
        case Kind::Coherence:
        case Kind::Views:
        case Kind::PlacedViews:
        case Kind::Strip:
        case Kind::Gradient:
        case Kind::Recoloring:
        case Kind::Levels:
        case Kind::Mesh:
        case Kind::Objects:
        case Kind::Occlusion:
        case Kind::Lights:     // the playback
        case Kind::Animation:  // tells what they are at its frame
            break;
    }
}

void ViewportLink::showScene() {
    const scene::Scene scene = m_meshes.scene();
    m_viewport.setScene(scene);
    showFrame();
    std::vector<std::shared_ptr<const scene::Mesh>> meshes;
    for (const scene::Object& object : scene.objects) meshes.push_back(object.mesh);
    if (meshes == m_framed) return;
    m_framed = std::move(meshes);
    m_viewport.setCamera(m_playback.view().camera);
}

void ViewportLink::showFrame() {
    const scene::View view = m_playback.view();
    const scene::Path& path = m_document.project().animation.path;
    const bool movesCamera = path.cameraTurn != 0 || !path.keyFrames(scene::Path::Part::Camera).empty();
    m_viewport.setLights(view.lights);
    m_textures.setLights(view.lights);
    if (movesCamera || m_movesCamera) m_viewport.setCamera(view.camera);
    m_movesCamera = movesCamera;
}

void ViewportLink::showPaint(int sample) {
    m_viewport.setPaint(sample, {m_paints.state(sample).levels, m_paints.gradient(sample)});
}

}  // namespace chiaro::app
