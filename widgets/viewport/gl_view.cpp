#include "widgets/viewport/gl_view.h"

#include "widgets/viewport/pane_gap.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QScopeGuard>
#include <QTimer>

namespace chiaro::widgets {

namespace {

constexpr int fadeMilliseconds = 120;
constexpr double slowFrame = 30;  // ms; a fade of fewer frames would only come late

}  // namespace

GlView::GlView(ViewState& state, QWidget* parent) : QOpenGLWidget(parent), m_state(state) {
    setFormat(openGlFormat());
    setAttribute(Qt::WA_TransparentForMouseEvents);
}

GlView::~GlView() {
    // The context goes down after this class has: its signal must not come back here.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseGl();
}

void GlView::initializeGL() {
    m_gl = QOpenGLVersionFunctionsFactory::get<Gl>(context());
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlView::releaseGl);
    if (m_gl && m_drawer.initialize(*m_gl) && m_compared.initialize(*m_gl)) return;
    m_gl = nullptr;
    QMetaObject::invokeMethod(this, &GlView::failed, Qt::QueuedConnection);
}

void GlView::releaseGl() {
    if (!m_gl) return;
    makeCurrent();
    m_drawer.release(*m_gl);
    m_compared.release(*m_gl);
    m_gl = nullptr;
    doneCurrent();
}

void GlView::paintGL() {
    if (!m_gl) return;
    QElapsedTimer timer;
    timer.start();
    const QSize pixels = size() * devicePixelRatioF();
    const bool complete = drawMethods(pixels);
    const double milliseconds = double(timer.nsecsElapsed()) * 1e-6;
    m_lastMilliseconds = milliseconds;
    if (m_state.earlierTexture)
        QMetaObject::invokeMethod(this, qOverload<>(&QWidget::update), Qt::QueuedConnection);
    if (!complete) QTimer::singleShot(10, this, qOverload<>(&QWidget::update));
    // Told later: who listens may do what must not be done while painting.
    QMetaObject::invokeMethod(
        this, [this, milliseconds] { Q_EMIT frameDrawn(milliseconds); }, Qt::QueuedConnection);
}

bool GlView::drawMethods(QSize pixels) {
    const std::vector<std::string> methods = m_state.shownMethods();
    const QSize size = paneRects(m_state.composition(), pixels, devicePixelRatioF()).front().size();
    m_state.follow(size);
    stepFade();
    m_times.clear();
    if (methods.size() == 1) {
        m_compared.reserve(*m_gl, 0, {});
        return drawMethod(methods.front(), pixels, defaultFramebufferObject());
    }
    m_compared.reserve(*m_gl, methods.size(), size);
    bool complete = true;
    for (std::size_t i = 0; i < methods.size(); ++i)
        complete &= drawMethod(methods[i], size, m_compared.target(i));
    m_compared.show(*m_gl, m_state.composition(), pixels, devicePixelRatioF(), gapColor(m_state.background),
                    defaultFramebufferObject());
    return complete;
}

bool GlView::drawMethod(const std::string& method, QSize pixels, GLuint target) {
    QElapsedTimer timer;
    timer.start();
    const bool complete = m_drawer.draw(*m_gl, m_state, method, pixels, target, m_pending);
    // So that the figure is the frame's and not the queue's; the window has nothing else to draw meanwhile.
    m_gl->glFinish();
    m_times.push_back(double(timer.nsecsElapsed()) * 1e-6);
    return complete;
}

void GlView::fadeTexture() {
    m_fade.start();
}

void GlView::stepFade() {
    const bool isOver = !m_fade.isValid() || m_fade.elapsed() >= fadeMilliseconds ||
                        m_lastMilliseconds > slowFrame || m_pending == GlPaints::Pending::Await;
    if (isOver || !m_state.viewTexture) m_state.earlierTexture = nullptr;
    m_state.earlierWeight =
        m_state.earlierTexture ? 1 - float(m_fade.elapsed() + 1) / (fadeMilliseconds + 1) : 0;
}

QImage GlView::picture() {
    m_pending = GlPaints::Pending::Await;
    const auto showAgain = qScopeGuard([this] { m_pending = GlPaints::Pending::Show; });
    QImage image = grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    image.setDevicePixelRatio(1);
    return image;
}

}  // namespace chiaro::widgets
