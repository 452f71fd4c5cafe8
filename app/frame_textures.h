#pragma once

#include "app/change.h"
#include "core/methods/image_based.h"
#include "core/scene/gbuffer.h"
#include "widgets/viewport/view_texture.h"

#include <QObject>
#include <QSize>
#include <QTimer>

#include <memory>
#include <set>

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;
class Memo;
class Paints;

/// What becomes of the image-based texture (§4.1) of the view that is shown, while the document's method is
/// that. Made in the background, a draft first; the last texture stays until there is a newer one.
///
/// While the artist drags the light or the camera, drafts follow one another, one at a time, each of the
/// newest state; the fine texture is made when that rests, and remembered under
/// the hash of what it comes from. Recolouring is in no hash: G(L) is added where the texture is shown.
class FrameTextures : public QObject {
    Q_OBJECT

public:
    FrameTextures(Document& document, JobRunner& jobs, Memo& memo, Paints& paints, Meshes& meshes,
                  QObject* parent = nullptr);

    /// The view to make textures for, in device pixels.
    void setView(const scene::Camera& camera, QSize pixels);
    /// The lights of the frame that is shown; the document's until they are told.
    void setLights(const std::vector<scene::Light>& lights);

    /// Null while there is none.
    const std::shared_ptr<const widgets::ViewTexture>& texture() const { return m_texture; }
    /// False while a draft, or the texture of something else, is shown.
    bool isFinal() const { return m_isFinal; }
    /// How many syntheses were begun, and how many of them were drafts.
    int synthesisCount() const { return m_synthesisCount; }
    int draftCount() const { return m_draftCount; }

public Q_SLOTS:
    /// Makes again what was cancelled or failed.
    void retry();

Q_SIGNALS:
    void textureChanged();

private:
    /// Hashes of what a texture comes from.
    struct Keys {
        std::uint64_t meshes = 0;
        std::uint64_t geometry = 0;  ///< these, and where they are
        std::uint64_t content = 0;   ///< that, what they wear, and the parameters
        std::uint64_t view = 0;      ///< all of that, the lights and the view
    };
    struct Inputs;
    struct Made;
    using Rays = std::shared_ptr<const scene::RayScene>;

    void applyChange(Change change);
    void refresh();
    bool isWanted() const;
    /// What an object wears is on its way for the first time.
    bool isWaitingForPaint() const;
    Inputs inputs() const;
    Keys keysOf(const Inputs& inputs) const;
    void stop();
    void start(Inputs inputs, const Keys& keys, bool isDraft);
    void take(Made made, const Keys& keys, bool isDraft);
    void show(std::shared_ptr<const widgets::ViewTexture> texture, const Keys& keys, bool isFinal);
    static Made make(const Inputs& inputs, bool isDraft, const Task& task);

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    Paints& m_paints;
    Meshes& m_meshes;
    scene::Camera m_camera;
    std::optional<std::vector<scene::Light>> m_lights;
    QSize m_pixels;
    std::shared_ptr<const widgets::ViewTexture> m_texture;
    Keys m_shownKeys;
    bool m_isFinal = false;
    Keys m_workKeys;  ///< of what is being made
    bool m_workIsDraft = false;
    Rays m_rays;  ///< of the geometry below
    std::uint64_t m_raysGeometry = 0;
    std::set<std::uint64_t>
        m_givenUp;                 ///< views that were cancelled or failed; not tried again by themselves
    std::uint64_t m_lastView = 0;  ///< as refreshed last
    QTimer m_rest;                 ///< the fine texture waits until nothing changed for this long
    int m_synthesisCount = 0;
    int m_draftCount = 0;
};

}  // namespace chiaro::app
