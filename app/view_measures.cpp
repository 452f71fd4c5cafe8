#include "app/view_measures.h"

#include "app/jobs/job_runner.h"
#include "app/paints.h"
#include "core/base/hash.h"
#include "core/metrics/heat_map.h"
#include "widgets/picture.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 400;
constexpr int coarseStep = 4;
constexpr int stripSide = 256;  ///< of the pictures that best matches are marked in

std::uint64_t indexKey(const SeparatedStrip& strip, const gradient::Gradient& gradient, int block) {
    Hasher hasher;
    hasher.add("strip index").add(strip.key).add(std::span(gradient)).add(block);
    return hasher.value();
}

}  // namespace

/// A sample that objects of the view wear.
struct ViewMeasures::Strip {
    std::shared_ptr<const SeparatedStrip> separated;
    gradient::Gradient gradient;
    MeasuredStrip measured;  ///< its index null: to be made
    std::uint64_t key = 0;
};

struct ViewMeasures::Inputs {
    std::vector<widgets::ViewSnapshot> views;
    std::vector<Strip> strips;
    Rays rays;  ///< null: to be cast
};

/// The pictures, ready to be measured further.
struct ViewMeasures::Prepared {
    scene::Scene scene;
    Rays rays;
    std::vector<MeasuredView> views;
    std::vector<Strip> strips;
    std::vector<MeasuredStrip> measured;  ///< theirs
    std::vector<widgets::HeatStrip> pictures;
    std::vector<metrics::FrameMeasure> measures;  ///< one a view
};

struct ViewMeasures::Maps {
    HeatMaps similarity, shading;  ///< one a view
};

ViewMeasures::ViewMeasures(JobRunner& jobs, Paints& paints, Source source, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_paints(paints), m_source(std::move(source)) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ViewMeasures::begin);
    connect(&jobs, &JobRunner::progressed, this, [this] {
        if (m_mapJob != 0) Q_EMIT mapChanged();
    });
    connect(&paints, &Paints::separationChanged, this, &ViewMeasures::restart);
}

void ViewMeasures::setLive(bool isLive) {
    if (std::exchange(m_isLive, isLive) == isLive) return;
    if (!m_prepared) restart();
}

void ViewMeasures::setMap(Map map) {
    if (std::exchange(m_map, map) == map) return;
    Q_EMIT mapChanged();
    if (map == Map::None) {
        if (std::exchange(m_mapJob, 0) != 0) m_jobs.supersede(slot);
    } else if (!m_prepared) {
        restart();
    } else if (!m_isMapFinal && m_mapJob == 0) {
        startMaps(m_maps ? 1 : coarseStep);
    }
}

void ViewMeasures::restart() {
    const bool hadMap = m_maps || m_mapJob != 0;
    const bool hadMeasure = m_prepared || !m_problem.isEmpty();
    m_prepared = nullptr;
    m_problem.clear();
    m_maps = nullptr;
    m_isMapFinal = false;
    m_mapJob = 0;
    m_jobs.supersede(slot);
    if (hadMeasure) Q_EMIT measureChanged();
    if (hadMap) Q_EMIT mapChanged();
    if (isWanted())
        m_rest.start();
    else
        m_rest.stop();
}

std::optional<metrics::FrameMeasure> ViewMeasures::measure(std::size_t picture) const {
    if (!m_prepared || picture >= m_prepared->measures.size()) return std::nullopt;
    return m_prepared->measures[picture];
}

ViewMeasures::HeatMaps ViewMeasures::heatMaps() const {
    if (!m_maps || m_map == Map::None) return {};
    return m_map == Map::Similarity ? m_maps->similarity : m_maps->shading;
}

std::shared_ptr<const widgets::HeatMap> ViewMeasures::heatMap(std::size_t picture) const {
    const HeatMaps maps = heatMaps();
    return picture < maps.size() ? maps[picture] : nullptr;
}

std::optional<double> ViewMeasures::mapProgress() const {
    for (const JobRunner::JobInfo& job : m_jobs.jobs())
        if (m_mapJob != 0 && job.number == m_mapJob) return job.progress;
    return std::nullopt;
}

/// None while nothing that is painted is seen.
std::optional<ViewMeasures::Inputs> ViewMeasures::inputs() const {
    Inputs inputs{m_source(), {}, m_rays};
    const scene::Scene& scene = inputs.views.front().scene;
    if (inputs.views.front().pixels.isEmpty()) return std::nullopt;
    if (!widgets::sameSurfaces(m_raysScene, scene)) inputs.rays = nullptr;
    const metrics::MeasureParams params;
    for (int sample = 0; sample < m_paints.sampleCount(); ++sample) {
        Strip strip;
        strip.measured.wears.assign(scene.objects.size() + 1, false);
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            strip.measured.wears[i + 1] =
                widgets::isDrawn(scene.objects[i]) && scene.objects[i].sample == sample;
        strip.separated = m_paints.state(sample).separated;
        if (!strip.separated || std::ranges::find(strip.measured.wears, true) == strip.measured.wears.end())
            continue;
        strip.gradient = m_paints.gradient(sample);
        strip.key = indexKey(*strip.separated, strip.gradient, params.block);
        if (const auto known = m_indices.find(strip.key); known != m_indices.end())
            strip.measured.index = known->second;
        inputs.strips.push_back(std::move(strip));
    }
    return inputs.strips.empty() ? std::nullopt : std::optional(std::move(inputs));
}

void ViewMeasures::begin() {
    auto measured = inputs();
    if (!measured) return;
    m_jobs.start(
        {tr("Measuring the view"), slot, [this](const QString& message) { fail(message); }, {}, true},
        [inputs = std::move(*measured)](const Task& task) { return prepare(inputs, task); },
        [this](const std::shared_ptr<const Prepared>& prepared) { take(prepared); });
}

std::shared_ptr<const ViewMeasures::Prepared> ViewMeasures::prepare(const Inputs& inputs, const Task& task) {
    auto prepared = std::make_shared<Prepared>();
    const widgets::ViewSnapshot& view = inputs.views.front();
    const metrics::MeasureParams params;
    prepared->scene = view.scene;
    prepared->rays =
        inputs.rays ? inputs.rays : std::make_shared<const scene::RayScene>(view.scene, task.part(0, 0.1));
    const scene::GBuffer gbuffer =
        scene::castGBuffer(prepared->rays->with(view.scene.occlusion), view.scene.lights, view.camera,
                           view.pixels.width(), view.pixels.height(), task.part(0.1, 0.3));
    // Only what lies wholly on an object is measured, so what is behind doesn't matter.
    for (const widgets::ViewSnapshot& one : inputs.views)
        prepared->views.push_back(
            {methods::over(widgets::shaded(one, gbuffer, 1, task.part(0.3, 0.5)).picture, one.background),
             gbuffer.objectId, gbuffer.light});
    prepared->strips = inputs.strips;
    prepared->pictures.resize(view.scene.objects.size());
    for (Strip& strip : prepared->strips) {
        const SeparatedStrip& separated = *strip.separated;
        const ColorImage& texture = *separated.texture;
        if (!strip.measured.index)
            strip.measured.index = std::make_shared<const metrics::NeighbourIndex>(
                gradient::recolored(texture, gradient::resample(strip.gradient, texture.width())),
                params.block, task.part(0.5, 0.8));
        prepared->measured.push_back(strip.measured);
        const ColorImage small = widgets::reduced(separated.pictures->texture, 2 * stripSide, stripSide);
        const widgets::HeatStrip picture{
            widgets::toImage(gradient::recolored(small, gradient::resample(strip.gradient, small.width()))),
            QSize(texture.width(), texture.height())};
        for (std::size_t object = 1; object < strip.measured.wears.size(); ++object)
            if (strip.measured.wears[object]) prepared->pictures[object - 1] = picture;
    }
    for (const MeasuredView& one : prepared->views)
        prepared->measures.push_back(measureView(one, prepared->measured, params, task.part(0.8, 1)).measure);
    return prepared;
}

void ViewMeasures::take(const std::shared_ptr<const Prepared>& prepared) {
    m_prepared = prepared;
    m_rays = prepared->rays;
    m_raysScene = prepared->scene;
    m_indices.clear();
    for (const Strip& strip : prepared->strips) m_indices.emplace(strip.key, strip.measured.index);
    Q_EMIT measureChanged();
    if (m_map != Map::None) startMaps(coarseStep);
}

void ViewMeasures::startMaps(int step) {
    m_mapJob = m_jobs.start(
        {tr("Measuring every pixel"), slot,
         // So little may be seen that a coarse map meets none of it.
         [this, step](const QString& message) { step > 1 ? startMaps(1) : fail(message); },
         [this] {
             m_mapJob = 0;
             Q_EMIT mapChanged();
         }},
        [prepared = m_prepared, step](const Task& task) { return makeMaps(*prepared, step, task); },
        [this, step](const std::shared_ptr<const Maps>& maps) {
            m_maps = maps;
            m_isMapFinal = step == 1;
            m_mapJob = 0;
            if (step > 1 && m_map != Map::None) startMaps(1);
            Q_EMIT mapChanged();
        });
    Q_EMIT mapChanged();
}

std::shared_ptr<const ViewMeasures::Maps> ViewMeasures::makeMaps(const Prepared& prepared, int step,
                                                                 const Task& task) {
    const metrics::MeasureParams params;
    std::vector<ViewMaps> found;
    for (const MeasuredView& view : prepared.views) {
        const double count = double(prepared.views.size()), done = double(found.size());
        found.push_back(mapView(view, prepared.measured, step, params.neighbours,
                                task.part(done / count, (done + 1) / count)));
    }
    return std::make_shared<const Maps>(
        Maps{heatMapsOf(prepared, found, tr("Similarity error"), &ViewMaps::similarity),
             heatMapsOf(prepared, found, tr("Shading error"), &ViewMaps::shadingError)});
}

/// Of one of the errors, all in the same colours.
ViewMeasures::HeatMaps ViewMeasures::heatMapsOf(const Prepared& prepared, const std::vector<ViewMaps>& found,
                                                const QString& title, ScalarImage ViewMaps::*values) {
    float most = 0;
    for (const ViewMaps& one : found) most = std::max(most, metrics::heatMapEnd(one.*values));
    HeatMaps maps;
    for (std::size_t view = 0; view < found.size(); ++view) {
        auto map = std::make_shared<widgets::HeatMap>();
        map->title = title;
        map->most = most;
        map->values = found[view].*values;
        map->best = found[view].best;
        map->objects = prepared.views[view].objects;
        map->strips = prepared.pictures;
        map->paint();
        maps.push_back(std::move(map));
    }
    return maps;
}

void ViewMeasures::fail(const QString& message) {
    m_problem = message;
    m_mapJob = 0;
    Q_EMIT measureChanged();
    Q_EMIT mapChanged();
}

}  // namespace chiaro::app
