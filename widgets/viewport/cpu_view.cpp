#include "widgets/viewport/cpu_view.h"

#include "widgets/viewport/pane_gap.h"
#include "widgets/viewport/view_snapshot.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QtConcurrent>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int coarse = 4;  // pixels a side that a coarse picture's pixel stands for

QColor toQColor(glm::vec3 color) {
    const glm::ivec3 bytes(color * 255.0f + 0.5f);
    return {bytes.r, bytes.g, bytes.b};
}

QImage toQImage(const ColorImage& picture) {
    QImage image(picture.width(), picture.height(), QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        QRgb* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (const glm::vec3& color : picture.row(y)) {
            const glm::ivec3 bytes(color * 255.0f + 0.5f);
            *row++ = qRgb(bytes.r, bytes.g, bytes.b);
        }
    }
    return image;
}

}  // namespace

struct CpuView::Job {
    std::vector<ViewSnapshot> views;  ///< one a method; else alike
    Rays rays;                        ///< null: to be built
    std::stop_token stopFine;
    std::stop_token stopAll;
};

CpuView::CpuView(ViewState& state, QWidget* parent) : QWidget(parent), m_state(state) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &CpuView::start);
    connect(&m_watcher, &QFutureWatcher<Result>::resultReadyAt, this, &CpuView::take);
    connect(&m_watcher, &QFutureWatcher<Result>::finished, this, [this] {
        if (m_stale) start();
    });
}

CpuView::~CpuView() {
    m_stopFine.request_stop();
    m_stopAll.request_stop();
    m_watcher.waitForFinished();
}

void CpuView::refresh() {
    m_stale = true;
    m_stopFine.request_stop();
    if (!sameSurfaces(m_raysScene, m_state.scene())) m_stopAll.request_stop();
    if (!m_watcher.isRunning()) m_soon.start(0);
}

CpuView::Job CpuView::jobOfNow() {
    if (!sameSurfaces(m_raysScene, m_state.scene())) m_rays.reset();
    m_raysScene = m_state.scene();
    m_stopFine = {};
    m_stopAll = {};
    const double ratio = devicePixelRatioF();
    const QSize pixels = paneRects(m_state.composition(), size() * ratio, ratio).front().size();
    Job job{{}, m_rays, m_stopFine.get_token(), m_stopAll.get_token()};
    for (const std::string& method : m_state.shownMethods())
        job.views.push_back(ViewSnapshot::of(m_state, method, pixels));
    return job;
}

void CpuView::start() {
    if (m_watcher.isRunning() || size().isEmpty()) return;
    m_stale = false;
    m_watcher.setFuture(QtConcurrent::run(&CpuView::run, jobOfNow()));
}

CpuView::Result CpuView::rendered(const Job& job, const Rays& rays, int coarseness, std::stop_token stop) {
    QElapsedTimer timer;
    timer.start();
    const Task task(stop);
    const ViewSnapshot& view = job.views.front();
    const QSize size(std::max(1, view.pixels.width() / coarseness),
                     std::max(1, view.pixels.height() / coarseness));
    const scene::GBuffer gbuffer = scene::castGBuffer(rays->with(view.scene.occlusion), view.scene.lights,
                                                      view.camera, size.width(), size.height(), task);
    const auto elapsed = [&timer] { return double(timer.nsecsElapsed()) * 1e-6; };
    Result result{rays, {}, {}, elapsed(), coarseness == 1};
    const double casting = result.milliseconds;
    for (const ViewSnapshot& one : job.views) {
        const double start = elapsed();
        const methods::Frame frame = shaded(one, gbuffer, coarseness, task);
        result.images.push_back(toQImage(methods::over(frame.picture, one.background)));
        result.times.push_back(casting + elapsed() - start);
    }
    result.milliseconds = elapsed();
    return result;
}

void CpuView::run(QPromise<Result>& promise, const Job& job) {
    try {
        const Rays rays =
            job.rays ? job.rays
                     : std::make_shared<const scene::RayScene>(job.views.front().scene, Task(job.stopAll));
        promise.addResult(rendered(job, rays, coarse, job.stopAll));
        promise.addResult(rendered(job, rays, 1, job.stopFine));
    } catch (const Cancelled&) {
        // Something newer is to be shown.
    } catch (const std::exception& problem) {
        qWarning("no picture: %s", problem.what());
    }
}

void CpuView::take(int index) {
    const Result result = m_watcher.resultAt(index);
    m_rays = result.rays;
    show(result);
    if (result.fine) Q_EMIT frameDrawn(result.milliseconds);
}

void CpuView::show(const Result& result) {
    m_images = result.images;
    if (result.fine) m_times = result.times;
    recompose();
}

void CpuView::recompose() {
    // Pictures of other methods than now are not to be mistaken for these: those on their way replace them.
    if (m_images.size() != m_state.composition().shownCount()) return;
    const double ratio = devicePixelRatioF();
    m_image = composed(m_state.composition(), m_images, size() * ratio, ratio,
                       toQColor(gapColor(m_state.background)));
    update();
}

QImage CpuView::picture() {
    m_stopFine.request_stop();
    m_watcher.waitForFinished();
    m_watcher.setFuture({});  // what it still had to say is older
    m_stale = false;
    const Job job = jobOfNow();
    if (job.views.front().pixels.isEmpty()) return {};
    if (!m_rays) m_rays = std::make_shared<const scene::RayScene>(job.views.front().scene);
    show(rendered(job, m_rays, 1, {}));
    return m_image;
}

void CpuView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), toQColor(m_state.background));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_image.isNull()) painter.drawImage(rect(), m_image);
}

void CpuView::resizeEvent(QResizeEvent*) {
    refresh();
}

}  // namespace chiaro::widgets
