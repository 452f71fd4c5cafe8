#include "app/method_comparison.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/meshes.h"
#include "widgets/viewport/view_state.h"

#include <QtWidgets>

namespace chiaro::app {

const ParameterTable<ComparisonSettings>& ComparisonSettings::table() {
    using Settings = ComparisonSettings;
    static const auto table =
        ParameterTable<Settings>()
            .add(&Settings::movement,
                 ParameterSpec::choice(
                     "movement", QT_TRANSLATE_NOOP("Core", "Movement"),
                     {QT_TRANSLATE_NOOP("Core", "approach"), QT_TRANSLATE_NOOP("Core", "turntable"),
                      QT_TRANSLATE_NOOP("Core", "timeline")},
                     QT_TRANSLATE_NOOP("Core",
                                       "What moves: the camera comes nearer, it goes around, or what the "
                                       "timeline's keys say.")))
            .add(&Settings::asReported,
                 ParameterSpec::boolean(
                     "as-reported", QT_TRANSLATE_NOOP("Core", "As reported"),
                     QT_TRANSLATE_NOOP("Core",
                                       "Let methods animate as in the report: each image-based frame close "
                                       "to the one before, a 3D texture that keeps its scale. Off: as this "
                                       "project says.")))
            .add(&Settings::frames,
                 ParameterSpec::integer(
                     "frames", QT_TRANSLATE_NOOP("Core", "Frames"), "", 2, 240,
                     QT_TRANSLATE_NOOP("Core", "How many frames are painted and measured.")))
            .add(&Settings::period,
                 ParameterSpec::integer(
                     "period", QT_TRANSLATE_NOOP("Core", "Turn"), QT_TRANSLATE_NOOP("Core", "frames"), 2,
                     1000, QT_TRANSLATE_NOOP("Core", "In how many frames a turntable goes around.")))
            .add(&Settings::size,
                 ParameterSpec::integer("size", QT_TRANSLATE_NOOP("Core", "Size"),
                                        QT_TRANSLATE_NOOP("Core", "px"), 64, 2048,
                                        QT_TRANSLATE_NOOP("Core", "Width and height of the frames.")))
            .add(&Settings::seeds,
                 ParameterSpec::integer(
                     "seeds", QT_TRANSLATE_NOOP("Core", "Seeds"), "", 1, 20,
                     QT_TRANSLATE_NOOP("Core",
                                       "How many syntheses are averaged; their spread tells how sure the "
                                       "figures are.")))
            .add(&Settings::pixels,
                 ParameterSpec::integer(
                     "pixels", QT_TRANSLATE_NOOP("Core", "Pixels"), "", 10, 10000,
                     QT_TRANSLATE_NOOP("Core",
                                       "How many pixels are drawn by chance and measured in each frame.")));
    return table;
}

namespace {

scene::Path pathOf(const ComparisonSettings& settings, const project::Project& project) {
    using Movement = ComparisonSettings::Movement;
    switch (settings.movement) {
        case Movement::Approach:
            return scene::Path::approaching();
        case Movement::Turntable:
            return scene::Path::turntable(settings.period);
        case Movement::Timeline:
            return project.animation.path;
    }
    return {};
}

}  // namespace

MethodComparison::MethodComparison(Document& document, JobRunner& jobs, Meshes& meshes, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_meshes(meshes) {
    connect(&document, &Document::changed, this, &MethodComparison::applyChange);
    connect(&meshes, &Meshes::sceneChanged, this, &MethodComparison::changed);
    connect(&jobs, &JobRunner::progressed, this, [this] {
        if (m_job != 0) Q_EMIT progressed();
    });
}

bool MethodComparison::canStart() const {
    return !m_document.project().samples.empty() &&
           std::ranges::any_of(m_meshes.scene().objects, widgets::isDrawn);
}

bool MethodComparison::isRunning() const {
    return m_job != 0;
}

double MethodComparison::progress() const {
    for (const JobRunner::JobInfo& job : m_jobs.jobs())
        if (job.number == m_job) return job.progress;
    return 0;
}

void MethodComparison::applyChange(Change change) {
    if (change.kind == Change::Kind::Method) return;
    using Movement = ComparisonSettings::Movement;
    const bool isOfTimeline = (m_result && m_result->settings.movement == Movement::Timeline) ||
                              (m_job != 0 && m_movement == Movement::Timeline);
    if (change.kind == Change::Kind::Animation && !isOfTimeline) return;
    m_isOutdated = m_result != nullptr;
    if (change.kind == Change::Kind::Everything) {
        m_result = nullptr;
        m_isOutdated = false;
        m_problem.clear();
    }
    if (std::exchange(m_job, 0) != 0) {
        m_problem = tr("The project was edited while it was measured: measure again");
        m_jobs.supersede(slot);
    }
    Q_EMIT changed();
}

void MethodComparison::start(const ComparisonSettings& settings) {
    ComparisonSettings::table().check(settings);
    if (!canStart()) return;
    Comparison comparison;
    comparison.settings = settings;
    comparison.path = pathOf(settings, m_document.project());
    m_movement = settings.movement;
    const scene::Scene scene = m_meshes.scene();
    comparison.start = {project::cameraFor(m_document.project(), scene), scene.lights};
    project::ComparisonParams params;
    params.width = params.height = settings.size;
    params.frames = settings.frames;
    params.seeds = settings.seeds;
    params.measure.pixels = settings.pixels;
    m_problem.clear();
    m_job = m_jobs.start(
        {tr("Comparing the methods"), slot,
         [this](const QString& message) {
             m_job = 0;
             m_problem = message;
             Q_EMIT changed();
         },
         [this] {
             m_job = 0;
             Q_EMIT changed();
         }},
        [comparison, params, scene,
         project =
             settings.asReported ? project::animatedAsReported(m_document.project()) : m_document.project(),
         cache = m_cache](const Task& task) {
            auto found = std::make_shared<Comparison>(comparison);
            found->table = project::compareMethods(project, scene, found->path, params, task, cache.get());
            for (project::MethodMeasure& method : found->table) method.frames = {};
            return std::shared_ptr<const Comparison>(std::move(found));
        },
        [this](const std::shared_ptr<const Comparison>& found) {
            m_job = 0;
            m_result = found;
            m_isOutdated = false;
            Q_EMIT changed();
        });
    Q_EMIT changed();
}

void MethodComparison::cancel() {
    if (m_job != 0) m_jobs.cancel(m_job);
}

}  // namespace chiaro::app
