#include "app/face_groups.h"

#include "app/jobs/job_runner.h"
#include "app/view_plans.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int coarseStep = 4;
constexpr int alpha = 150;  ///< the paint below still shows

using Colors = std::vector<QRgb>;

/// One a face of an object; clear where no view took it. Of several views the one that it faces most counts.
Colors faceColors(const CoveredPlan* plan) {
    if (!plan) return {};
    const views::Surface& surface = plan->planned->surface;
    Colors colors(surface.faceCount(), 0);
    std::vector<double> best(surface.faceCount(), -1);
    const auto& groups = plan->planned->plan.groups;
    for (std::size_t group = 0; group < groups.size(); ++group) {
        const views::Projector projector(groups[group].view);
        QColor color = FaceGroups::colorOf(group);
        color.setAlpha(alpha);
        for (const std::uint32_t face : groups[group].faces) {
            const double facing = projector.facing(surface.centroid(face), surface.normal(face));
            if (facing <= best[face]) continue;
            best[face] = facing;
            colors[face] = qPremultiply(color.rgba());
        }
    }
    return colors;
}

}  // namespace

struct FaceGroups::Inputs {
    scene::Scene scene;
    scene::Camera camera;
    QSize pixels;
    std::vector<std::shared_ptr<const CoveredPlan>> plans;  ///< one an object; null where there is none
    Rays rays;                                              ///< null: to be built
};

FaceGroups::FaceGroups(JobRunner& jobs, ViewPlans& plans, widgets::Viewport& viewport, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_plans(plans), m_viewport(viewport) {
    connect(&viewport, &widgets::Viewport::viewChanged, this, &FaceGroups::refresh);
    connect(&plans, &ViewPlans::planChanged, this, &FaceGroups::refresh);
    connect(&plans, &ViewPlans::objectsChanged, this, &FaceGroups::refresh);
}

QColor FaceGroups::colorOf(std::size_t group) {
    // The golden ratio leaves the largest gaps between hues that follow each other.
    const double hue = std::fmod(0.08 + 0.618034 * double(group), 1.0);
    return QColor::fromHsvF(float(hue), group % 2 == 0 ? 0.75F : 0.5F, 0.95F);
}

void FaceGroups::setWanted(bool isWanted) {
    if (std::exchange(m_isWanted, isWanted) != isWanted || isWanted) refresh();
}

void FaceGroups::refresh() {
    if (!m_isWanted) {
        m_jobs.supersede(slot);
        m_isCoarse = false;
        if (!std::exchange(m_picture, {}).isNull()) Q_EMIT pictureChanged();
        return;
    }
    m_isStale = true;
    if (!m_isCoarse) start(coarseStep);
}

FaceGroups::Inputs FaceGroups::inputs() const {
    widgets::ViewSnapshot view = m_viewport.snapshots().front();
    Inputs inputs{std::move(view.scene), view.camera, view.pixels, {}, m_rays};
    if (!widgets::sameSurfaces(m_raysScene, inputs.scene)) inputs.rays = nullptr;
    for (int object = 0; object < int(inputs.scene.objects.size()); ++object) {
        auto plan = m_plans.lastPlan(object);
        const scene::Mesh* mesh = inputs.scene.objects[std::size_t(object)].mesh.get();
        if (plan && &plan->planned->surface.mesh() != mesh) plan = nullptr;
        inputs.plans.push_back(std::move(plan));
    }
    return inputs;
}

void FaceGroups::start(int step) {
    Inputs now = inputs();
    m_isStale = false;
    m_isCoarse = step > 1;
    if (now.pixels.isEmpty()) return void(m_isCoarse = false);
    m_raysScene = now.scene;
    m_rays = now.rays;
    m_jobs.start(
        {tr("Colouring face groups"), slot, [this](const QString&) { m_isCoarse = false; }, {}, true},
        [inputs = std::move(now), step](const Task& task) { return make(inputs, step, task); },
        [this](const Made& made) { take(made); });
}

void FaceGroups::take(const Made& made) {
    m_rays = made.rays;
    m_picture = made.picture;
    const bool wasCoarse = std::exchange(m_isCoarse, false);
    if (wasCoarse) start(m_isStale ? coarseStep : 1);
    Q_EMIT pictureChanged();
}

FaceGroups::Made FaceGroups::make(const Inputs& inputs, int step, const Task& task) {
    const Rays rays =
        inputs.rays ? inputs.rays : std::make_shared<const scene::RayScene>(inputs.scene, task.part(0, 0.4));
    const QSize size(std::max(1, inputs.pixels.width() / step), std::max(1, inputs.pixels.height() / step));
    const scene::GBuffer gbuffer = scene::castGBuffer(rays->with({}), inputs.scene.lights, inputs.camera,
                                                      size.width(), size.height(), task.part(0.4, 0.9));
    std::vector<Colors> colors;
    for (const auto& plan : inputs.plans) colors.push_back(faceColors(plan.get()));
    Made made{QImage(size, QImage::Format_ARGB32_Premultiplied), rays};
    for (int y = 0; y < size.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(made.picture.scanLine(y));
        for (int x = 0; x < size.width(); ++x) {
            const std::uint16_t object = gbuffer.objectId(x, y);
            const bool isGrouped = object > 0 && !colors[object - 1U].empty();
            line[x] = isGrouped ? colors[object - 1U][gbuffer.faceId(x, y)] : 0;
        }
    }
    return made;
}

}  // namespace chiaro::app
