#include "widgets/viewport/viewport.h"

#include "widgets/viewport/light_sphere.h"
#include "widgets/viewport/picking.h"
#include "widgets/viewport/picture_view.h"

#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointer>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace chiaro::widgets {

struct Viewport::Impl {
    explicit Impl(Viewport& owner) : widget(owner) {}

    Viewport& widget;
    ViewState state;
    Navigation navigation = Navigation::Blender;
    PictureView* picture = nullptr;
    LightSphere* sphere = nullptr;
    QLabel* note = nullptr;
    std::vector<QPointer<QWidget>> overlays;

    Gesture gesture = Gesture::None;
    Qt::MouseButton button = Qt::NoButton;  ///< whose drag it is
    QRectF pane;                            ///< that the drag began in
    QPointF pressed;                        ///< in it
    QPointF last;
    bool lightTurned = false;
    int light = 0;  ///< that drags turn

    const scene::Light* turnedLight() const;
    glm::vec3 wayToLight() const;
    glm::vec3 vectorFor(glm::vec3 way) const;
    QRectF paneAt(QPointF position) const;
    QSizeF paneSize() const { return widget.panes().front().rect.size(); }
    void refresh();
    void showNote();
    void placeOverlays();

    void move(const scene::Camera& camera);
    void turnLight(glm::vec3 vector);
    void finishDrag();
    void drag(QPointF position);
    void frame(const scene::Scene& scene);
    void frameUnderCursor();
};

/// The gap beside a pane belongs to the one before it.
QRectF Viewport::Impl::paneAt(QPointF position) const {
    const std::vector<Pane> panes = widget.panes();
    QRectF found = panes.front().rect;
    for (const Pane& one : panes)
        if (position.x() >= one.rect.left() && position.y() >= one.rect.top()) found = one.rect;
    return found;
}

const scene::Light* Viewport::Impl::turnedLight() const {
    const auto& lights = state.scene().lights;
    return light >= 0 && light < int(lights.size()) ? &lights[std::size_t(light)] : nullptr;
}

/// From the camera's target, around which a light at a point goes.
glm::vec3 Viewport::Impl::wayToLight() const {
    const scene::Light& one = *turnedLight();
    return one.kind == scene::Light::Kind::Point ? one.vector - state.camera.target : one.vector;
}

glm::vec3 Viewport::Impl::vectorFor(glm::vec3 way) const {
    return turnedLight()->kind == scene::Light::Kind::Point ? state.camera.target + way : way;
}

void Viewport::Impl::refresh() {
    picture->refresh();
    const int sample = state.scene().objects.empty() ? 0 : state.scene().objects.front().sample;
    sphere->show(state.scene().lights, state.camera, state.paint(sample).gradient);
    Q_EMIT widget.pictureChanged();
}

void Viewport::Impl::showNote() {
    note->setText(picture->note());
    note->setVisible(!picture->usesOpenGl());
    placeOverlays();
}

void Viewport::Impl::placeOverlays() {
    constexpr int margin = 12;
    sphere->move(widget.width() - sphere->width() - margin, margin);
    for (const QPointer<QWidget>& overlay : overlays)
        if (overlay) overlay->setGeometry(widget.rect());
    note->setWordWrap(false);
    const int width = std::min(note->sizeHint().width(), widget.width() - 2 * margin);
    note->setWordWrap(true);
    note->resize(width, note->heightForWidth(width));
    note->move(margin, widget.height() - note->height() - margin);
}

void Viewport::Impl::move(const scene::Camera& camera) {
    if (camera == state.camera) return;
    Q_EMIT widget.cameraAboutToBeEdited();
    state.camera = camera;
    refresh();
    Q_EMIT widget.viewChanged();
    Q_EMIT widget.cameraEdited(camera);
}

void Viewport::Impl::turnLight(glm::vec3 vector) {
    std::vector<scene::Light> lights = state.scene().lights;
    lights[std::size_t(light)].vector = vector;
    state.setLights(lights);
    lightTurned = true;
    refresh();
    Q_EMIT widget.lightEdited(light, vector);
}

void Viewport::Impl::finishDrag() {
    const bool movedCamera = gesture == Gesture::Orbit || gesture == Gesture::Pan || gesture == Gesture::Zoom;
    gesture = Gesture::None;
    if (movedCamera) Q_EMIT widget.cameraEditFinished();
    if (std::exchange(lightTurned, false)) Q_EMIT widget.lightEditFinished();
}

void Viewport::Impl::drag(QPointF position) {
    const QPointF delta = position - std::exchange(last, position);
    switch (gesture) {
        case Gesture::None:
            return;
        case Gesture::Orbit:
            return move(orbited(state.camera, delta));
        case Gesture::Pan:
            return move(panned(state.camera, delta, pane.size()));
        case Gesture::Zoom:
            return move(zoomed(state.camera, dragZoomFactor(float(delta.y())), pressed, pane.size()));
        case Gesture::Light:
            if (turnedLight()) turnLight(vectorFor(widgets::turnedLight(wayToLight(), state.camera, delta)));
            return;
    }
}

void Viewport::Impl::frame(const scene::Scene& scene) {
    if (std::ranges::none_of(scene.objects, isDrawn)) return;
    scene::Camera camera = state.camera.framed(scene::boundsOf(scene));
    camera.distance = 1;
    move(camera);
}

void Viewport::Impl::frameUnderCursor() {
    const QPointF cursor = widget.mapFromGlobal(QPointF(QCursor::pos()));
    const bool inside = QRectF(widget.rect()).contains(cursor);
    const QRectF under = paneAt(cursor);
    const auto object =
        inside ? objectAt(state.scene(), state.camera, cursor - under.topLeft(), under.size()) : std::nullopt;
    frame(object ? scene::Scene{{state.scene().objects[*object]}, {}} : state.scene());
}

Viewport::Viewport(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>(*this)) {
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Viewport"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_impl->picture = new PictureView(m_impl->state, this);
    layout->addWidget(m_impl->picture);
    m_impl->note = new QLabel(this);
    m_impl->note->setStyleSheet("background: rgba(0, 0, 0, 150); color: white; padding: 4px 8px;");
    m_impl->note->hide();
    m_impl->sphere = new LightSphere(this);
    connect(m_impl->picture, &PictureView::frameDrawn, this, &Viewport::frameDrawn);
    connect(m_impl->picture, &PictureView::rendererChanged, this, [this] { m_impl->showNote(); });
    connect(m_impl->sphere, &LightSphere::lightDragged, this, [this](glm::vec3 direction) {
        if (!m_impl->turnedLight()) return;
        m_impl->turnLight(m_impl->vectorFor(direction * glm::length(m_impl->wayToLight())));
    });
    connect(m_impl->sphere, &LightSphere::dragFinished, this, [this] { m_impl->finishDrag(); });
    m_impl->refresh();
}

Viewport::~Viewport() {
    delete m_impl->picture;  // it reads the state
}

bool Viewport::usesOpenGl() const {
    return m_impl->picture->usesOpenGl();
}

void Viewport::setScene(const scene::Scene& scene) {
    m_impl->state.setScene(scene);
    m_impl->refresh();
}

void Viewport::setLights(const std::vector<scene::Light>& lights) {
    m_impl->state.setLights(lights);
    m_impl->refresh();
}

void Viewport::setTurnedLight(int light) {
    m_impl->light = light;
}

void Viewport::setCamera(const scene::Camera& camera) {
    if (camera == m_impl->state.camera) return;
    m_impl->state.camera = camera;
    m_impl->refresh();
    Q_EMIT viewChanged();
}

const scene::Camera& Viewport::camera() const {
    return m_impl->state.camera;
}

void Viewport::setPaint(int sample, ViewportPaint paint) {
    m_impl->state.setPaint(sample, std::move(paint));
    m_impl->refresh();
}

void Viewport::setGradient(int sample, const gradient::Gradient& gradient) {
    m_impl->state.setGradient(sample, gradient);
    m_impl->refresh();
}

void Viewport::setParams(const methods::ViewAlignedParams& params) {
    m_impl->state.params = params;
    m_impl->refresh();
}

void Viewport::setMethod(const std::string& key) {
    m_impl->state.setMethod(key);
    if (m_impl->state.shownMethods().size() == 1) m_impl->refresh();
}

void Viewport::setComposition(const Composition& composition) {
    ViewState& state = m_impl->state;
    if (composition == state.composition()) return;
    const std::vector<std::string> methods = state.shownMethods();
    const QSize pane = pixels();
    state.setComposition(composition);
    if (state.shownMethods() == methods && pixels() == pane)
        m_impl->picture->recompose();
    else
        m_impl->refresh();
    Q_EMIT panesChanged();
    if (pixels() != pane) Q_EMIT viewChanged();
}

std::vector<std::string> Viewport::shownMethods() const {
    return m_impl->state.shownMethods();
}

std::vector<Pane> Viewport::panes() const {
    return panesOf(m_impl->state.composition(), size(), devicePixelRatioF());
}

const std::vector<double>& Viewport::methodTimes() const {
    return m_impl->picture->methodTimes();
}

void Viewport::moveCamera(const scene::Camera& camera) {
    m_impl->move(camera);
}

bool Viewport::isDragging() const {
    return m_impl->gesture != Gesture::None;
}

void Viewport::setViewTexture(std::shared_ptr<const ViewTexture> texture) {
    m_impl->state.earlierTexture = std::exchange(m_impl->state.viewTexture, std::move(texture));
    m_impl->picture->fadeTexture();
    if (m_impl->state.shows("image-based")) m_impl->refresh();
}

void Viewport::setPaintedObjects(std::vector<std::shared_ptr<const methods::PaintedObject>> objects) {
    m_impl->state.setPaintedObjects(std::move(objects));
    if (m_impl->state.shows("view-dependent")) m_impl->refresh();
}

void Viewport::setViewDependent(const methods::ViewDependentParams& params) {
    m_impl->state.viewDependent = params;
    m_impl->refresh();
}

void Viewport::setNavigation(Navigation navigation) {
    m_impl->navigation = navigation;
}

void Viewport::setBackground(glm::vec3 color) {
    m_impl->state.background = color;
    m_impl->refresh();
}

glm::vec3 Viewport::background() const {
    return m_impl->state.background;
}

void Viewport::frameAll() {
    m_impl->frame(m_impl->state.scene());
}

QImage Viewport::picture() const {
    return m_impl->picture->picture();
}

QSize Viewport::pixels() const {
    const double ratio = devicePixelRatioF();
    return paneRects(m_impl->state.composition(), size() * ratio, ratio).front().size();
}

std::vector<methods::TexturePlacement> Viewport::placements() const {
    m_impl->state.follow(pixels());
    return m_impl->state.placements();
}

std::vector<ViewSnapshot> Viewport::snapshots() const {
    std::vector<ViewSnapshot> snapshots;
    for (const std::string& method : m_impl->state.shownMethods())
        snapshots.push_back(ViewSnapshot::of(m_impl->state, method, pixels()));
    return snapshots;
}

void Viewport::addOverlay(QWidget* overlay) {
    overlay->setParent(this);
    overlay->setGeometry(rect());
    overlay->lower();
    m_impl->picture->lower();
    m_impl->overlays.push_back(overlay);
}

bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Numpad keys are views here, whatever the plain digits are shortcuts of.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() & Qt::KeypadModifier &&
            keyMoved(m_impl->state.camera, key->key(), key->modifiers(), m_impl->paneSize()))
            event->accept();
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            const float factor = 1 / std::max(0.1f, 1 + float(gesture->value()));
            const QRectF pane = m_impl->paneAt(gesture->position());
            m_impl->move(
                zoomed(m_impl->state.camera, factor, gesture->position() - pane.topLeft(), pane.size()));
            return true;
        }
    }
    if (event->type() == QEvent::ScreenChangeInternal) Q_EMIT viewChanged();  // its ratio may be another
    return QWidget::event(event);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (m_impl->gesture != Gesture::None) return;
    m_impl->gesture = dragGesture(m_impl->navigation, event->button(), event->modifiers());
    m_impl->button = event->button();
    m_impl->pane = m_impl->paneAt(event->position());
    m_impl->pressed = m_impl->last = event->position() - m_impl->pane.topLeft();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    m_impl->drag(event->position() - m_impl->pane.topLeft());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != m_impl->button) return;
    m_impl->finishDrag();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    // Alt turns a vertical wheel into a horizontal one.
    const QPoint angle = event->angleDelta();
    const QRectF pane = m_impl->paneAt(event->position());
    const QPointF pixels = event->pixelDelta().isNull() ? QPointF(angle) / 4 : QPointF(event->pixelDelta());
    switch (scrollGesture(m_impl->navigation, event->modifiers())) {
        case Gesture::Orbit:
            m_impl->move(orbited(m_impl->state.camera, pixels));
            break;
        case Gesture::Pan:
            m_impl->move(panned(m_impl->state.camera, pixels, pane.size()));
            break;
        default: {
            const float factor = wheelZoomFactor(float(angle.y() != 0 ? angle.y() : angle.x()));
            m_impl->move(
                zoomed(m_impl->state.camera, factor, event->position() - pane.topLeft(), pane.size()));
        }
    }
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Home) return m_impl->frame(m_impl->state.scene());
    if (event->key() == Qt::Key_F && event->modifiers() == Qt::NoModifier) return m_impl->frameUnderCursor();
    if (const auto camera =
            keyMoved(m_impl->state.camera, event->key(), event->modifiers(), m_impl->paneSize()))
        return m_impl->move(*camera);
    QWidget::keyPressEvent(event);
}

void Viewport::resizeEvent(QResizeEvent*) {
    m_impl->placeOverlays();
    Q_EMIT panesChanged();
    Q_EMIT viewChanged();
    Q_EMIT pictureChanged();
}

void Viewport::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void Viewport::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    Q_EMIT filesDropped(paths);
}

}  // namespace chiaro::widgets
