#pragma once

#include "core/gradient/gradient.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_dependent.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/synthesis/levels.h"
#include "widgets/viewport/composition.h"
#include "widgets/viewport/view_texture.h"

#include <QSize>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiaro::widgets {

/// What one paint sample gives the viewport. Shared immutable snapshots.
struct ViewportPaint {
    std::shared_ptr<const synthesis::LevelStack> levels;  ///< null: G(L) alone is shown
    gradient::Gradient gradient;                          ///< empty: a plain grey
};

/// True for what the eye can meet: visible, and with a mesh that has faces.
bool isDrawn(const scene::Object& object);

/// The methods that views can draw, by the keys of project::RenderMethod.
std::span<const std::string> drawnMethods();

/// Everything a view draws, and where each object's texture lies (§4.2). The OpenGL and the CPU view draw the
/// same state.
class ViewState {
public:
    ViewState();

    const scene::Scene& scene() const { return m_scene; }
    /// An object that was there before (the same mesh under the same name) keeps its placement.
    void setScene(const scene::Scene& scene);
    void setLights(const std::vector<scene::Light>& lights) { m_scene.lights = lights; }

    /// The paint of a sample; one that was never set is a plain grey without texture.
    const ViewportPaint& paint(int sample) const;
    void setPaint(int sample, ViewportPaint paint);
    void setGradient(int sample, const gradient::Gradient& gradient);

    /// The method that is shown while none are compared.
    const std::string& method() const { return m_method; }
    /// One of drawnMethods(); any other shows as the first of them.
    void setMethod(const std::string& key);
    const Composition& composition() const { return m_composition; }
    /// Its methods are of drawnMethods(); any other shows as the first of them.
    void setComposition(Composition composition);
    /// The methods that are seen, each in a picture of its own; one while none are compared.
    std::vector<std::string> shownMethods() const;
    bool shows(const std::string& method) const;

    /// The textures of an object's own views, null while there are none: G(L) alone is shown.
    std::shared_ptr<const methods::PaintedObject> paintedObject(std::size_t object) const;
    /// One an object of the scene; those of another mesh than the object's are not shown.
    void setPaintedObjects(std::vector<std::shared_ptr<const methods::PaintedObject>> objects) {
        m_paintedObjects = std::move(objects);
    }

    scene::Camera camera;
    methods::ViewAlignedParams params;
    std::shared_ptr<const ViewTexture> viewTexture;     ///< image-based; null: G(L) alone is shown
    std::shared_ptr<const ViewTexture> earlierTexture;  ///< what it takes the place of, while it fades in
    float earlierWeight = 0;                            ///< of that, 1 to 0
    methods::ViewDependentParams viewDependent;
    glm::vec3 background{0.22f};

    /// Lets the textures follow what moved since the last call, for a view of so many device pixels. A view
    /// of another size moves them but does not scale them: a larger window shows as large strokes.
    void follow(QSize pixels);
    const std::vector<methods::TexturePlacement>& placements() const { return m_placements; }
    /// ViewTexture::motions in a view of so many pixels.
    std::vector<methods::TexturePlacement> textureMotions(const ViewTexture& texture, QSize pixels) const;

private:
    methods::TexturePlacement followed(std::size_t object, const methods::ObjectView& now) const;

    std::string m_method;
    Composition m_composition;
    scene::Scene m_scene;
    std::map<int, ViewportPaint> m_paints;
    std::vector<std::shared_ptr<const methods::PaintedObject>> m_paintedObjects;
    std::vector<methods::TexturePlacement> m_placements;     ///< one an object
    std::vector<std::optional<methods::ObjectView>> m_seen;  ///< as last followed, one an object
    scene::Camera m_seenCamera;
};

}  // namespace chiaro::widgets
