#include "app/view_plans.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "app/meshes.h"
#include "core/base/hash.h"
#include "core/project/pipeline.h"
#include "core/project/render_method.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 150;

CoveredPlan makePlan(const project::Project& project, const scene::Scene& scene, int object,
                     const Task& task) {
    CoveredPlan made;
    made.planned = project::planObject(project, scene, std::size_t(object), task.part(0, 0.95));
    made.coverage = views::measureCoverage(made.planned->surface, made.planned->plan);
    return made;
}

}  // namespace

std::size_t CoveredPlan::bytes() const {
    // What a surface keeps of a face: its welded corners, its normal and its area.
    constexpr std::size_t bytesPerFace = sizeof(scene::Triangle) + sizeof(glm::dvec3) + sizeof(double);
    std::size_t bytes = planned->surface.faceCount() * bytesPerFace;
    for (const views::FaceGroup& group : planned->plan.groups)
        bytes += sizeof group + group.faces.size() * sizeof(std::uint32_t);
    return bytes;
}

ViewPlans::ViewPlans(Document& document, JobRunner& jobs, Memo& memo, Meshes& meshes, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_memo(memo), m_meshes(meshes) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ViewPlans::startNext);
    connect(&document, &Document::changed, this, &ViewPlans::applyChange);
    connect(&meshes, &Meshes::sceneChanged, this, &ViewPlans::refresh);
    refresh();
}

void ViewPlans::setWanted(const QObject* who, bool wanted) {
    if (wanted)
        m_wanting.insert(who);
    else
        m_wanting.erase(who);
    refresh();
}

bool ViewPlans::isWanted() const {
    return !m_wanting.empty() || m_document.shows(&project::RenderMethod::usesViews);
}

std::shared_ptr<const CoveredPlan> ViewPlans::plan(int object) const {
    const auto last = lastPlan(object);
    return last && last->key == m_entries[std::size_t(object)].key ? last : nullptr;
}

std::shared_ptr<const CoveredPlan> ViewPlans::lastPlan(int object) const {
    return object >= 0 && object < objectCount() ? m_entries[std::size_t(object)].last : nullptr;
}

void ViewPlans::retry() {
    m_givenUp.clear();
    refresh();
}

void ViewPlans::applyChange(Change change) {
    using Kind = Change::Kind;
    switch (change.kind) {
        case Kind::Everything:
            m_givenUp.clear();
            return refresh();
        case Kind::Samples:
        case Kind::Method:
        case Kind::Views:
        case Kind::PlacedViews:
            return refresh();
        case Kind::Mesh:     // the scene that comes
        case Kind::Objects:  // of it tells itself
        case Kind::Occlusion:
        case Kind::Animation:
        case Kind::Strip:
        case Kind::Gradient:
        case Kind::Recoloring:
        case Kind::Lights:
        case Kind::Levels:
        case Kind::ViewAligned:
        case Kind::ImageBased:
        case Kind::Coherence:
        case Kind::ViewDependent:
            return;
    }
}

std::uint64_t ViewPlans::keyOf(int object, const scene::Object& one) const {
    const project::Project& project = m_document.project();
    if (!one.visible || !one.mesh) return 0;
    Hasher hasher;
    // A plan keeps its mesh, so that no other mesh gets the same address while it is remembered.
    hasher.add("view plan").add(m_meshes.contentKey(object)).add(project::scaleOf(one));
    hasher.add(reinterpret_cast<std::uintptr_t>(one.mesh.get()));
    for (const double value : views::ViewParams::table().values(project.views)) hasher.add(value);
    hasher.add(project.views.up.x).add(project.views.up.y).add(project.views.up.z);
    for (const scene::Object& other : m_meshes.scene().objects) hasher.add(project::scaleOf(other));
    hasher.add(std::span<const project::PlacedView>(m_document.placedViews(object)));
    return hasher.value();
}

void ViewPlans::refresh() {
    const std::vector<scene::Object> objects = m_meshes.scene().objects;
    if (m_meshKey != m_meshes.contentKey() || m_entries.size() != objects.size()) {
        m_meshKey = m_meshes.contentKey();
        m_entries.assign(objects.size(), {});
        Q_EMIT objectsChanged();
    }
    for (int object = 0; object < objectCount(); ++object) follow(object, objects[std::size_t(object)]);
    startNext();
}

/// Finds out which plan there should be, and whether it is there.
void ViewPlans::follow(int object, const scene::Object& one) {
    Entry& entry = m_entries[std::size_t(object)];
    const std::uint64_t key = keyOf(object, one);
    const bool isOther = std::exchange(entry.key, key) != key;
    if (isOther && entry.last) m_rest.start();
    bool isFound = false;
    if (key != 0 && (!entry.last || entry.last->key != key))
        if (auto plan = m_memo.find<CoveredPlan>(key)) {
            entry.last = std::move(plan);
            isFound = true;
        }
    if (isOther || isFound) Q_EMIT planChanged(object);
}

bool ViewPlans::isWantedOf(int object) const {
    const Entry& entry = m_entries[std::size_t(object)];
    return entry.key != 0 && !plan(object) && !m_givenUp.contains(entry.key);
}

void ViewPlans::startNext() {
    int next = -1;
    for (int object = objectCount() - 1; isWanted() && object >= 0; --object) {
        if (!isWantedOf(object)) continue;
        if (m_jobs.isRunning(slot) && m_inWork == m_entries[std::size_t(object)].key) return;
        next = object;
    }
    if (next < 0 || (m_rest.isActive() && lastPlan(next))) return m_jobs.supersede(slot);
    start(next);
}

void ViewPlans::start(int object) {
    ++m_planCount;
    const std::uint64_t key = m_inWork = m_entries[std::size_t(object)].key;
    const scene::Scene scene = m_meshes.scene();
    const scene::Object& one = scene.objects[std::size_t(object)];
    m_jobs.start(
        {tr("Planning views of %1").arg(QString::fromStdString(one.name)), slot,
         [this, key](const QString& message) {
             m_givenUp.insert(key);
             Q_EMIT m_jobs.failed(message);
             startNext();
         },
         [this] {  // those that wait are not to begin instead
             for (const Entry& entry : m_entries) m_givenUp.insert(entry.key);
         }},
        [project = m_document.project(), scene, object, key](const Task& task) {
            auto made = std::make_shared<CoveredPlan>(makePlan(project, scene, object, task));
            made->key = key;
            return std::shared_ptr<const CoveredPlan>(std::move(made));
        },
        [this](std::shared_ptr<const CoveredPlan> plan) { take(std::move(plan)); });
}

void ViewPlans::take(std::shared_ptr<const CoveredPlan> plan) {
    m_memo.insert(plan->key, plan, plan->bytes());
    for (int object = 0; object < objectCount(); ++object)
        if (m_entries[std::size_t(object)].key == plan->key) {
            m_entries[std::size_t(object)].last = plan;
            Q_EMIT planChanged(object);
        }
    startNext();
}

}  // namespace chiaro::app
