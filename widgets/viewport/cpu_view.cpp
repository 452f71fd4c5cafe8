#include "widgets/viewport/cpu_view.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QtConcurrent>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int coarse = 4;  // pixels a side that a coarse picture's pixel stands for

bool sameSurfaces(const scene::Scene& a, const scene::Scene& b) {
    return std::ranges::equal(a.objects, b.objects, [](const scene::Object& x, const scene::Object& y) {
        return x.mesh == y.mesh && x.transform == y.transform && x.visible == y.visible;
    });
}

std::shared_ptr<const synthesis::LevelStack> noTexture() {
    static const auto stack = std::make_shared<const synthesis::LevelStack>(
        synthesis::LevelStack{{ColorImage(1, 1, glm::vec3(0))}, {}});
    return stack;
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

/// A snapshot of the state, for another thread.
struct CpuView::Job {
    Rays rays;  ///< null: to be built
    scene::Scene scene;
    scene::Camera camera;
    std::vector<ViewportPaint> paints{};  ///< one an object
    std::vector<methods::TexturePlacement> placements;
    std::string method;
    methods::ViewAlignedParams params;
    std::shared_ptr<const ViewTexture> viewTexture;
    std::vector<methods::TexturePlacement> motions{};                      ///< of the view texture
    std::vector<std::shared_ptr<const methods::PaintedObject>> painted{};  ///< one an object
    methods::ViewDependentParams viewDependent;
    glm::vec3 background{0};
    QSize pixels;
    std::stop_token stopFine;
    std::stop_token stopAll;
};

/// The texture of a coarse picture's pixels, at their middle: it keeps its place and size on the screen.
methods::TextureLookup CpuView::levelLookup(const Job& job, int coarseness) {
    methods::ViewAlignedParams params = job.params;
    params.density *= coarseness;
    std::vector<methods::ViewAlignedPaint> paints;
    for (std::size_t i = 0; i < job.paints.size(); ++i) {
        const ViewportPaint& paint = job.paints[i];
        methods::TexturePlacement placement = job.placements[i];
        placement.offset /= float(coarseness);
        const bool textured = paint.levels && !paint.levels->levels.empty();
        paints.push_back({textured ? paint.levels.get() : noTexture().get(), &paint.gradient, placement});
    }
    return [paints = std::move(paints), params](std::uint16_t object, int x, int y, float light) {
        return methods::viewAlignedTexture(paints[object - 1u], params, glm::vec2(x, y) + 0.5f, light);
    };
}

methods::TextureLookup CpuView::viewTextureLookup(const Job& job, int coarseness) {
    return [&job, coarseness](std::uint16_t object, int x, int y, float) {
        if (!job.viewTexture) return glm::vec3(0);
        const methods::TexturePlacement& motion = job.motions[object - 1u];
        const glm::vec2 position = (glm::vec2(x, y) + 0.5f) * float(coarseness);
        return job.viewTexture->difference(object - 1u, (position - motion.offset) / motion.zoom);
    };
}

methods::Frame CpuView::shaded(const Job& job, const scene::GBuffer& gbuffer, int coarseness,
                               const Task& task) {
    if (job.method == "view-dependent") {
        std::vector<methods::ViewDependentPaint> paints;
        for (std::size_t i = 0; i < job.paints.size(); ++i) {
            const glm::mat4 worldToObject = glm::inverse(job.scene.objects[i].transform);
            paints.push_back({job.painted[i].get(), &job.paints[i].gradient,
                              glm::vec3(worldToObject * glm::vec4(gbuffer.eye, 1))});
        }
        return methods::renderViewDependent(gbuffer, paints, job.viewDependent, task);
    }
    std::vector<const gradient::Gradient*> gradients;
    for (const ViewportPaint& paint : job.paints) gradients.push_back(&paint.gradient);
    const methods::TextureLookup texture =
        job.method == "image-based" ? viewTextureLookup(job, coarseness) : levelLookup(job, coarseness);
    return methods::shade(gbuffer, gradients, texture, task);
}

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
    const QSize pixels = size() * devicePixelRatioF();
    m_state.follow(pixels);
    if (!sameSurfaces(m_raysScene, m_state.scene())) m_rays.reset();
    m_raysScene = m_state.scene();
    m_stopFine = {};
    m_stopAll = {};
    Job job{.rays = m_rays,
            .scene = m_state.scene(),
            .camera = m_state.camera,
            .placements = m_state.placements(),
            .method = m_state.method(),
            .params = m_state.params,
            .viewTexture = m_state.viewTexture,
            .viewDependent = m_state.viewDependent,
            .background = m_state.background,
            .pixels = pixels,
            .stopFine = m_stopFine.get_token(),
            .stopAll = m_stopAll.get_token()};
    if (job.viewTexture) job.motions = m_state.textureMotions(*job.viewTexture, pixels);
    for (const scene::Object& object : job.scene.objects) job.paints.push_back(m_state.paint(object.sample));
    for (std::size_t i = 0; i < job.scene.objects.size(); ++i)
        job.painted.push_back(m_state.paintedObject(i));
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
    const QSize size(std::max(1, job.pixels.width() / coarseness),
                     std::max(1, job.pixels.height() / coarseness));
    const scene::GBuffer gbuffer = scene::castGBuffer(rays->with(job.scene.occlusion), job.scene.lights,
                                                      job.camera, size.width(), size.height(), task);
    const methods::Frame frame = shaded(job, gbuffer, coarseness, task);
    const QImage image = toQImage(methods::over(frame.picture, job.background));
    return {rays, image, double(timer.nsecsElapsed()) * 1e-6, coarseness == 1};
}

void CpuView::run(QPromise<Result>& promise, const Job& job) {
    try {
        const Rays rays =
            job.rays ? job.rays : std::make_shared<const scene::RayScene>(job.scene, Task(job.stopAll));
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
    m_image = result.image;
    update();
    if (result.fine) Q_EMIT frameDrawn(result.milliseconds);
}

QImage CpuView::picture() {
    m_stopFine.request_stop();
    m_watcher.waitForFinished();
    m_watcher.setFuture({});  // what it still had to say is older
    m_stale = false;
    const Job job = jobOfNow();
    if (job.pixels.isEmpty()) return {};
    if (!m_rays) m_rays = std::make_shared<const scene::RayScene>(job.scene);
    m_image = rendered(job, m_rays, 1, {}).image;
    return m_image;
}

void CpuView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const glm::ivec3 background(m_state.background * 255.0f + 0.5f);
    painter.fillRect(rect(), QColor(background.r, background.g, background.b));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_image.isNull()) painter.drawImage(rect(), m_image);
}

void CpuView::resizeEvent(QResizeEvent*) {
    refresh();
}

}  // namespace chiaro::widgets
