#pragma once

#include "widgets/viewport/navigation.h"
#include "widgets/viewport/view_snapshot.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <vector>

namespace chiaro::widgets {

/// The scene, live, by one of the methods (§4): turned, panned, zoomed and lit with the mouse. A frame that
/// holds the OpenGL view, or the CPU renderer's pictures where there is no OpenGL. It knows core's types,
/// never the document. Several methods are compared in panes, or over each other: their camera, light and
/// zoom are one and the same.
///
/// What the setters give is kept here, so the picture survives a new OpenGL context (a floated dock makes
/// one). Every setter takes effect with the next frame; none synthesises anything.
class Viewport : public QWidget {
    Q_OBJECT

public:
    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    /// False: the CPU renderer's pictures are shown, and a note over the picture says so. So it is without
    /// OpenGL, and while the scene has shadows or ambient occlusion, which only that renderer casts.
    bool usesOpenGl() const;

    /// Meshes are shared snapshots: only those that changed are uploaded. An object that was there before
    /// (the same mesh under the same name) keeps its place on the texture. Takes the scene's lights as well.
    void setScene(const scene::Scene& scene);
    void setLights(const std::vector<scene::Light>& lights);
    /// The light that drags turn; the first one at first.
    void setTurnedLight(int light);
    void setCamera(const scene::Camera& camera);
    const scene::Camera& camera() const;

    /// `sample` is the index that scene::Object::sample names.
    void setPaint(int sample, ViewportPaint paint);
    /// Another gradient over the same texture, in the next frame.
    void setGradient(int sample, const gradient::Gradient& gradient);
    void setParams(const methods::ViewAlignedParams& params);

    /// The key of the project::RenderMethod to show while none are compared; "view-aligned" at first.
    void setMethod(const std::string& key);
    /// How methods are compared; at first they are not.
    void setComposition(const Composition& composition);
    /// The methods that are seen, and where.
    std::vector<std::string> shownMethods() const;
    std::vector<Pane> panes() const;
    /// What each of them took in the last frame, ms; may lag behind what is shown.
    const std::vector<double>& methodTimes() const;
    /// The image-based texture, best of the view that viewChanged() told; null shows G(L) alone. The one
    /// before goes on being shown, moved along with its objects, until then.
    void setViewTexture(std::shared_ptr<const ViewTexture> texture);

    /// The textures of the objects' own views (§4.3), one an object of the scene; null shows G(L) alone.
    /// Texels are made of them in the background; what was shown before stays until they are ready.
    void setPaintedObjects(std::vector<std::shared_ptr<const methods::PaintedObject>> objects);
    void setViewDependent(const methods::ViewDependentParams& params);

    /// Which mouse gestures turn, pan and zoom; see navigation.h. A plain left drag turns in all of them.
    using Navigation = widgets::Navigation;
    void setNavigation(Navigation navigation);
    /// Display-referred RGB in [0, 1].
    void setBackground(glm::vec3 color);
    glm::vec3 background() const;
    /// Fits all visible objects (Home); cameraEdited follows.
    void frameAll();
    /// Moves the camera as navigation does; cameraEdited follows.
    void moveCamera(const scene::Camera& camera);
    bool isDragging() const;

    /// The scene as shown, in device pixels, without what lies over it (light sphere, note). Where the CPU
    /// renders, waits for the fine picture.
    QImage picture() const;
    /// The size of a method's picture, device pixels: the viewport's, or a pane's.
    QSize pixels() const;
    /// Where each object's view-aligned texture lies, as followed through all moves so far; device pixels.
    std::vector<methods::TexturePlacement> placements() const;
    /// All that the shown methods' pictures are made from, for another thread.
    std::vector<ViewSnapshot> snapshots() const;
    /// Puts a widget over the picture, as large as it, below all else that lies there; it belongs to the
    /// viewport.
    void addOverlay(QWidget* overlay);

Q_SIGNALS:
    void cameraAboutToBeEdited();                    ///< camera() is still that before
    void cameraEdited(const scene::Camera& camera);  ///< after every navigation step
    void cameraEditFinished();                       ///< the drag that moved it ended
    void viewChanged();                              ///< another camera, or another pixels()
    void panesChanged();                             ///< panes(), or how what lies in them is put together
    void pictureChanged();  ///< anything that the methods' pictures show, their size included
    void lightEdited(int light, glm::vec3 vector);  ///< while a drag turns the light
    void lightEditFinished();                       ///< the drag ended
    void frameDrawn(double milliseconds);           ///< a frame was drawn; how long that took
    void filesDropped(const QStringList& paths);    ///< local files, dragged from outside

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace chiaro::widgets
