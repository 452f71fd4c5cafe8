#include "app/object_textures.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "app/meshes.h"
#include "app/paints.h"
#include "app/view_plans.h"
#include "core/base/hash.h"
#include "core/project/pipeline.h"
#include "core/project/render_method.h"

#include <opencv2/imgproc.hpp>

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 350;
constexpr int coarseness = 4;  ///< texels of a fine map's side that one of a coarse one stands for
constexpr int smallestCoarseMap = 64;
const char* const slot = "object textures";

template <class Params>
void addParams(Hasher& hasher, const Params& params) {
    for (double value : Params::table().values(params)) hasher.add(value);
}

ColorImage reduced(const ColorImage& image, int width, int height) {
    ColorImage result(width, height);
    ColorImage copy = image;  // OpenCV has no pictures that can't be written to
    const cv::Mat from(copy.height(), copy.width(), CV_32FC3, copy.pixels().data());
    cv::Mat to(height, width, CV_32FC3, result.pixels().data());
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
    return result;
}

/// The strip and its gradient with fewer pixels.
project::Paint reduced(const project::Paint& paint) {
    const int width = std::max(paint.strip.width() / coarseness, 8);
    const int height = std::max(paint.strip.height() / coarseness, 8);
    project::Paint result;
    result.strip = reduced(paint.strip, width, height);
    const gradient::Gradient& gradient = paint.separation.gradient;
    ColorImage row(int(gradient.size()), 1);
    std::ranges::copy(gradient, row.pixels().begin());
    row = reduced(row, width, 1);
    result.separation.gradient.assign(row.pixels().begin(), row.pixels().end());
    return result;
}

/// The same views with smaller maps: nothing else of a plan depends on them but what a group hides, which
/// stays as it was found.
std::shared_ptr<const methods::PlannedObject> reduced(const methods::PlannedObject& planned) {
    auto result = std::make_shared<methods::PlannedObject>(planned);
    for (views::FaceGroup& group : result->plan.groups)
        group.view.size = std::max(group.view.size / coarseness, 1);
    return result;
}

std::size_t bytesOf(const methods::PaintedObject& painted) {
    std::size_t bytes = 0;
    for (const methods::ViewTexture& view : painted.textures.views)
        for (const auto& level : view.levels) bytes += level.pixelCount() * sizeof(methods::PackedTexel);
    for (const views::FaceGroup& group : painted.planned->plan.groups)
        bytes += group.faces.size() * (sizeof(methods::ViewWeights::FaceView) + sizeof(std::uint32_t));
    return bytes;
}

}  // namespace

/// A snapshot of all that a texture is made from.
struct ObjectTextures::Inputs {
    project::Project project;
    std::shared_ptr<const methods::PlannedObject> planned;
    std::shared_ptr<const SeparatedStrip> strip;
    bool isCoarse = false;
    std::shared_ptr<const project::TextureCache> cache;

    Painted made(const Task& task) const {
        project::Paint paint;
        paint.strip = *strip->strip;
        paint.separation.gradient = strip->separation.gradient;
        if (!isCoarse) return project::paintObject(project, planned, paint, task, cache.get());
        project::Project coarse = project;
        synthesis::QuiltParams& quilt = coarse.levels.quilt;
        quilt.block = std::max(quilt.block / coarseness, 4);
        quilt.overlap /= coarseness;
        return project::paintObject(coarse, reduced(*planned), reduced(paint), task);
    }
};

ObjectTextures::ObjectTextures(Document& document, JobRunner& jobs, Memo& memo, Paints& paints,
                               Meshes& meshes, ViewPlans& plans, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_jobs(jobs),
      m_memo(memo),
      m_paints(paints),
      m_meshes(meshes),
      m_plans(plans) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ObjectTextures::refresh);
    connect(&document, &Document::changed, this, &ObjectTextures::applyChange);
    connect(&document, &Document::editFinished, this, [this] {
        m_rest.stop();
        refresh();
    });
    connect(&paints, &Paints::separationChanged, this, &ObjectTextures::refresh);
    connect(&meshes, &Meshes::sceneChanged, this, &ObjectTextures::refresh);
    connect(&plans, &ViewPlans::planChanged, this, &ObjectTextures::refresh);
    connect(&plans, &ViewPlans::objectsChanged, this, &ObjectTextures::refresh);
}

std::vector<ObjectTextures::Painted> ObjectTextures::textures() const {
    std::vector<Painted> textures;
    for (const Entry& entry : m_entries) textures.push_back(entry.shown);
    return textures;
}

bool ObjectTextures::isFinal(int object) const {
    const Entry& entry = m_entries[std::size_t(object)];
    return !entry.isNeeded || (entry.shown && entry.fineKey != 0 && entry.shownKey == entry.fineKey);
}

bool ObjectTextures::isFinal() const {
    for (int object = 0; object < int(m_entries.size()); ++object)
        if (!isFinal(object)) return false;
    return true;
}

void ObjectTextures::retry() {
    m_givenUp.clear();
    refresh();
}

void ObjectTextures::applyChange(Change change) {
    using Kind = Change::Kind;
    switch (change.kind) {
        case Kind::Everything:
            m_givenUp.clear();
            return refresh();
        case Kind::Samples:
        case Kind::Method:
            return refresh();
        case Kind::Strip:
        case Kind::Gradient:
        case Kind::Levels:
        case Kind::Views:
        case Kind::PlacedViews:
        case Kind::ViewDependent:
            if (m_document.isEditing()) m_rest.start();
            return refresh();
        case Kind::Mesh:     // the scene that comes
        case Kind::Objects:  // of it tells itself
        case Kind::Occlusion:
        case Kind::Animation:
        case Kind::Recoloring:  // over the same texture
        case Kind::Lights:
        case Kind::ViewAligned:
        case Kind::ImageBased:
        case Kind::Coherence:
            return;
    }
}

bool ObjectTextures::isWanted() const {
    return m_document.shows(&project::RenderMethod::usesViews);
}

std::shared_ptr<const SeparatedStrip> ObjectTextures::stripOf(int object) const {
    const scene::Object one = m_meshes.scene().objects[std::size_t(object)];
    const bool isPainted = one.visible && one.sample < int(m_document.project().samples.size());
    return isPainted ? m_paints.state(one.sample).separated : nullptr;
}

std::uint64_t ObjectTextures::keyOf(int object, bool isCoarse) const {
    const project::Project& project = m_document.project();
    const auto plan = m_plans.plan(object);
    const auto strip = stripOf(object);
    if (!plan || !strip) return 0;
    const bool isSmall = project.views.size < coarseness * smallestCoarseMap;
    if (isCoarse && isSmall) return 0;
    Hasher hasher;
    hasher.add("object texture").add(isCoarse).add(plan->key).add(strip->key);
    hasher.add(project.levels.count).add(project.levels.base).add(project.viewDependent.propagate);
    addParams(hasher, project.levels.quilt);
    return hasher.value();
}

void ObjectTextures::refresh() {
    const std::size_t count = m_meshes.scene().objects.size();
    if (m_meshKey != m_meshes.contentKey() || m_entries.size() != count) {
        m_meshKey = m_meshes.contentKey();
        m_entries.assign(count, {});
        Q_EMIT texturesChanged();
    }
    for (int object = 0; object < int(count); ++object) follow(object);
    startNext();
}

/// Finds out which texture there should be, and whether it is there.
void ObjectTextures::follow(int object) {
    Entry& entry = m_entries[std::size_t(object)];
    const scene::Object one = m_meshes.scene().objects[std::size_t(object)];
    entry.isNeeded = one.visible && one.sample < int(m_document.project().samples.size());
    entry.fineKey = keyOf(object, false);
    entry.coarseKey = keyOf(object, true);
    if (entry.fineKey == 0 || entry.shownKey == entry.fineKey) return;
    for (const std::uint64_t key : {entry.fineKey, entry.coarseKey}) {
        if (key == entry.shownKey) return;
        auto painted = key == 0 ? nullptr : m_memo.find<methods::PaintedObject>(key);
        if (!painted) continue;
        entry.shown = std::move(painted);
        entry.shownKey = key;
        Q_EMIT texturesChanged();
        return;
    }
}

void ObjectTextures::startNext() {
    const auto lacksCoarse = [this](const Entry& entry) {
        return entry.fineKey != 0 && entry.coarseKey != 0 && entry.shownKey != entry.fineKey &&
               entry.shownKey != entry.coarseKey && !m_givenUp.contains(entry.coarseKey);
    };
    const auto lacksFine = [this](const Entry& entry) {
        return entry.fineKey != 0 && entry.shownKey != entry.fineKey && !m_givenUp.contains(entry.fineKey);
    };
    const bool isRunning = m_jobs.isRunning(slot);
    const auto isInWork = [&](const Entry& entry) {
        return isRunning && (m_inWork == entry.fineKey || m_inWork == entry.coarseKey);
    };
    const auto coarse = isWanted() ? std::ranges::find_if(m_entries, lacksCoarse) : m_entries.end();
    const auto fine = isWanted() ? std::ranges::find_if(m_entries, lacksFine) : m_entries.end();
    const bool isFineInWork = std::ranges::any_of(
        m_entries, [&](const Entry& entry) { return isRunning && m_inWork == entry.fineKey; });
    if (fine == m_entries.end()) return m_jobs.supersede(slot);
    // What is being made is wanted still; but a fine texture waits for others' coarse ones.
    const bool goesOn =
        std::ranges::any_of(m_entries, isInWork) && !(isFineInWork && coarse != m_entries.end());
    if (goesOn) return;
    if (coarse != m_entries.end()) return start(int(coarse - m_entries.begin()), true);
    if (m_rest.isActive()) return m_jobs.supersede(slot);
    start(int(fine - m_entries.begin()), false);
}

void ObjectTextures::start(int object, bool isCoarse) {
    ++m_synthesisCount;
    if (isCoarse) ++m_coarseCount;
    const Entry& entry = m_entries[std::size_t(object)];
    const std::uint64_t key = m_inWork = isCoarse ? entry.coarseKey : entry.fineKey;
    const QString name = QString::fromStdString(m_meshes.scene().objects[std::size_t(object)].name);
    const Inputs inputs{m_document.project(), m_plans.plan(object)->planned, stripOf(object), isCoarse,
                        m_cache};
    m_jobs.start(
        {(isCoarse ? tr("Sketching %1") : tr("Painting %1")).arg(name), slot,
         [this, key, isCoarse](const QString& message) {
             m_givenUp.insert(key);
             // The fine one works, or says what is wrong.
             if (!isCoarse) Q_EMIT m_jobs.failed(message);
             startNext();
         },
         [this] {  // those that wait are not to begin instead
             for (const Entry& one : m_entries) m_givenUp.insert({one.fineKey, one.coarseKey});
         }},
        [inputs](const Task& task) { return inputs.made(task); },
        [this, key](const Painted& painted) { take(key, painted); });
}

void ObjectTextures::take(std::uint64_t key, const Painted& painted) {
    m_memo.insert(key, painted, bytesOf(*painted));
    m_inWork = 0;
    for (Entry& entry : m_entries)
        if (entry.fineKey == key || entry.coarseKey == key) {
            entry.shown = painted;
            entry.shownKey = key;
        }
    Q_EMIT texturesChanged();
    startNext();
}

}  // namespace chiaro::app
