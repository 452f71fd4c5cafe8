#include "app/paints.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "core/base/hash.h"
#include "core/project/pipeline.h"
#include "core/project/render_method.h"
#include "widgets/picture.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 350;
constexpr int coarseSize = 128;
constexpr int shownScanSide = 1200;

QString slotName(const char* stage, int sample) {
    return QString("%1/%2").arg(stage).arg(sample);
}

template <class Params>
void addParams(Hasher& hasher, const Params& params) {
    for (double value : Params::table().values(params)) hasher.add(value);
}

std::size_t bytesOf(const synthesis::LevelStack& stack) {
    std::size_t bytes = 0;
    for (const ColorImage& level : stack.levels) bytes += level.pixelCount() * sizeof(glm::vec3);
    return bytes;
}

std::shared_ptr<const SeparatedStrip> separateStrip(std::shared_ptr<const ColorImage> strip,
                                                    const gradient::GradientParams& params, std::uint64_t key,
                                                    const Task& task) {
    SeparatedStrip separated{std::move(strip), params, {}, nullptr, nullptr, key};
    separated.separation = gradient::separate(*separated.strip, params, task);
    separated.pictures = std::make_shared<const widgets::StripPictures>(
        widgets::StripPictures::of(*separated.strip, separated.separation));
    separated.texture = std::make_shared<const ColorImage>(std::move(separated.separation.texture));
    separated.separation.texture = {};
    return std::make_shared<const SeparatedStrip>(std::move(separated));
}

}  // namespace

LoadedScan LoadedScan::read(const std::filesystem::path& path) {
    LoadedScan scan{sample::readScan(path), {}};
    scan.picture = widgets::toImage(widgets::reduced(scan.image, shownScanSide, shownScanSide));
    return scan;
}

Paints::Paints(Document& document, JobRunner& jobs, Memo& memo, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_memo(memo) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &Paints::refreshAll);
    connect(&document, &Document::changed, this, &Paints::applyChange);
    connect(&document, &Document::editFinished, this, [this] {
        m_rest.stop();
        refreshAll();
    });
    applyChange({});
}

void Paints::applyChange(Change change) {
    switch (change.kind) {
        case Change::Kind::Everything:
        case Change::Kind::Samples:
            for (int sample = 0; sample < int(m_states.size()); ++sample)
                for (const char* stage : {"scan", "separation", "levels"})
                    m_jobs.supersede(slotName(stage, sample));
            m_states.clear();
            m_states.resize(m_document.project().samples.size());
            m_givenUp.clear();
            return refreshAll();
        case Change::Kind::Recoloring:
            Q_EMIT gradientChanged(change.index);
            return;
        case Change::Kind::Strip:
        case Change::Kind::Gradient:
            if (m_document.isEditing()) m_rest.start();
            refresh(change.index);
            Q_EMIT gradientChanged(change.index);
            return;
        case Change::Kind::Levels:
            if (m_document.isEditing()) m_rest.start();
            return refreshAll();
        case Change::Kind::Mesh:
        case Change::Kind::Objects:  // other samples may be worn
        case Change::Kind::Method:
            return refreshAll();
        case Change::Kind::Lights:
        case Change::Kind::Occlusion:
        case Change::Kind::Animation:
        case Change::Kind::ViewAligned:
        case Change::Kind::ImageBased:
        case Change::Kind::Coherence:
        case Change::Kind::ViewDependent:
        case Change::Kind::Views:
        case Change::Kind::PlacedViews:
            return;
    }
}

gradient::Gradient Paints::gradient(int sample) const {
    const auto& separated = state(sample).separated;
    if (!separated) return {};
    const project::Sample& edited = m_document.project().samples[std::size_t(sample)];
    if (edited.recoloring) return project::shownGradient(edited, separated->separation);
    // A speed curve under the pointer is followed at once, before the strip is separated again.
    const bool sameSort = edited.gradient.searchScale == separated->params.searchScale;
    if (edited.gradient.matchSpeed || !sameSort) return separated->separation.gradient;
    gradient::Gradient followed;
    for (double u : edited.gradient.curve.sampled(int(separated->separation.sorted.size())))
        followed.push_back(gradient::lookUp(separated->separation.sorted, float(u)));
    return followed;
}

bool Paints::isSeparating(int sample) const {
    return m_jobs.isRunning(slotName("scan", sample)) || m_jobs.isRunning(slotName("separation", sample));
}

void Paints::remember(const std::filesystem::path& path, LoadedScan scan) {
    m_fileKeys.erase(path);
    const std::size_t bytes = scan.bytes();
    m_memo.insert(fileKey(path), std::make_shared<const LoadedScan>(std::move(scan)), bytes);
}

void Paints::retry() {
    m_givenUp.clear();
    m_fileKeys.clear();
    refreshAll();
}

void Paints::refreshAll() {
    for (int sample = 0; sample < int(m_states.size()); ++sample) refresh(sample);
}

void Paints::refresh(int sample) {
    if (sample >= int(m_states.size())) return;
    const Keys keys = keysOf(sample);
    if (!showScan(sample, keys)) return readScan(sample, keys);
    if (!showSeparation(sample, keys)) return separate(sample, keys);
    if (!m_document.shows(&project::RenderMethod::usesLevels)) return m_jobs.supersede(slotName("levels", sample));
    if (m_document.isWorn(sample)) refreshLevels(sample, keys);
}

bool Paints::showScan(int sample, const Keys& keys) {
    Entry& entry = m_states[std::size_t(sample)];
    if (entry.shown.scan && entry.shownKeys.scan == keys.scan) return true;
    auto scan = m_memo.find<LoadedScan>(keys.scan);
    if (!scan) return false;
    entry.shown.scan = std::move(scan);
    entry.shownKeys.scan = keys.scan;
    Q_EMIT scanChanged(sample);
    return true;
}

bool Paints::showSeparation(int sample, const Keys& keys) {
    const Entry& entry = m_states[std::size_t(sample)];
    if (entry.shown.separated && entry.shownKeys.separation == keys.separation) return true;
    auto separated = m_memo.find<SeparatedStrip>(keys.separation);
    if (!separated) return false;
    m_jobs.supersede(slotName("separation", sample));
    setSeparation(sample, keys.separation, std::move(separated));
    return true;
}

void Paints::setSeparation(int sample, std::uint64_t key, std::shared_ptr<const SeparatedStrip> separated) {
    Entry& entry = m_states[std::size_t(sample)];
    entry.shown.separated = std::move(separated);
    entry.shownKeys.separation = key;
    Q_EMIT separationChanged(sample);
    Q_EMIT gradientChanged(sample);
}

void Paints::refreshLevels(int sample, const Keys& keys) {
    Entry& entry = m_states[std::size_t(sample)];
    const QString slot = slotName("levels", sample);
    if (entry.shown.levelsAreFinal && entry.shownKeys.levels == keys.levels) return m_jobs.supersede(slot);
    if (auto levels = m_memo.find<synthesis::LevelStack>(keys.levels)) {
        m_jobs.supersede(slot);
        return setLevels(sample, keys.levels, std::move(levels), true);
    }
    entry.shown.levelsAreFinal = false;
    if (m_jobs.isRunning(slot) &&
        (entry.levelsInWork == keys.levels || entry.levelsInWork == keys.coarseLevels))
        return;
    m_jobs.supersede(slot);
    if (m_rest.isActive() || gaveUp(keys.levels)) return;

    const synthesis::LevelParams params = m_document.project().levels;
    auto coarse = m_memo.find<synthesis::LevelStack>(keys.coarseLevels);
    if (!coarse && params.size > 2 * coarseSize && !gaveUp(keys.coarseLevels)) {
        synthesis::LevelParams coarseParams = params;
        coarseParams.size = coarseSize;
        return synthesise(sample, keys.coarseLevels, coarseParams, false);
    }
    if (coarse) setLevels(sample, keys.coarseLevels, std::move(coarse), false);
    synthesise(sample, keys.levels, params, true);
}

void Paints::readScan(int sample, const Keys& keys) {
    if (gaveUp(keys.scan) || m_jobs.isRunning(slotName("scan", sample))) return;
    const std::filesystem::path path = m_document.project().samples[std::size_t(sample)].scan;
    m_jobs.start(
        spec(tr("Reading %1"), "scan", sample, keys.scan),
        [path](const Task&) { return std::make_shared<const LoadedScan>(LoadedScan::read(path)); },
        [this, sample, key = keys.scan](std::shared_ptr<const LoadedScan> scan) {
            const std::size_t bytes = scan->bytes();
            m_memo.insert(key, std::move(scan), bytes);
            refresh(sample);
        });
}

void Paints::separate(int sample, const Keys& keys) {
    // One at a time: while the artist drags, each result is shown and the newest parameters come next.
    if (gaveUp(keys.separation) || m_jobs.isRunning(slotName("separation", sample))) return;
    const project::Sample& edited = m_document.project().samples[std::size_t(sample)];
    m_jobs.start(
        spec(tr("Separating %1"), "separation", sample, keys.separation),
        [scan = state(sample).scan, strip = m_memo.find<ColorImage>(keys.strip), cut = edited.strip,
         params = edited.gradient, key = keys.separation](const Task& task) {
            auto cutStrip =
                strip ? strip : std::make_shared<const ColorImage>(sample::makeStrip(scan->image, cut));
            return separateStrip(std::move(cutStrip), params, key, task);
        },
        [this, sample, keys](std::shared_ptr<const SeparatedStrip> separated) {
            const std::size_t bytes = separated->strip->pixelCount() * sizeof(glm::vec3);
            m_memo.insert(keys.strip, separated->strip, bytes);  // and as much for the texture
            m_memo.insert(keys.separation, separated, bytes);
            setSeparation(sample, keys.separation, std::move(separated));
            refresh(sample);
        });
}

void Paints::synthesise(int sample, std::uint64_t key, const synthesis::LevelParams& params, bool isFinal) {
    ++m_synthesisCount;
    m_states[std::size_t(sample)].levelsInWork = key;
    JobSpec job = spec(isFinal ? tr("Synthesising %1") : tr("Sketching %1"), "levels", sample, key);
    job.cancelled = [this, keys = keysOf(sample)] { m_givenUp.insert({keys.levels, keys.coarseLevels}); };
    job.failed = [this, key, isFinal, sample](const QString& message) {
        m_givenUp.insert(key);
        if (!isFinal) return refresh(sample);  // the full one works, or says what is wrong
        setLevels(sample, 0, nullptr, false);
        Q_EMIT m_jobs.failed(message);
    };
    m_jobs.start(
        std::move(job),
        [separated = state(sample).separated, params](const Task& task) {
            return std::make_shared<const synthesis::LevelStack>(
                synthesis::makeLevels(*separated->strip, separated->separation.gradient, params, task));
        },
        [this, sample, key](std::shared_ptr<const synthesis::LevelStack> stack) {
            const std::size_t bytes = bytesOf(*stack);
            m_memo.insert(key, std::move(stack), bytes);
            refresh(sample);
        });
}

void Paints::setLevels(int sample, std::uint64_t key, std::shared_ptr<const synthesis::LevelStack> levels,
                       bool isFinal) {
    Entry& entry = m_states[std::size_t(sample)];
    entry.shown.levelsAreFinal = isFinal;
    entry.shownKeys.levels = key;
    if (levels == entry.shown.levels) return;
    entry.shown.levels = std::move(levels);
    Q_EMIT levelsChanged(sample);
}

JobSpec Paints::spec(const QString& title, const char* stage, int sample, std::uint64_t key) {
    const std::string& name = m_document.project().samples[std::size_t(sample)].name;
    return {title.arg(QString::fromStdString(name)), slotName(stage, sample),
            [this, key](const QString& message) {
                m_givenUp.insert(key);
                Q_EMIT m_jobs.failed(message);
            },
            [this, key] { m_givenUp.insert(key); }};
}

Paints::Keys Paints::keysOf(int sample) {
    const project::Project& project = m_document.project();
    const project::Sample& edited = project.samples[std::size_t(sample)];
    Keys keys;
    keys.scan = fileKey(edited.scan);

    Hasher strip;
    strip.add("strip").add(keys.scan);
    addParams(strip, edited.strip);
    for (glm::vec2 corner : edited.strip.crop) strip.add(corner.x).add(corner.y);
    keys.strip = strip.value();

    Hasher separation;
    separation.add("separation").add(keys.strip);
    addParams(separation, edited.gradient);
    if (!edited.gradient.matchSpeed)
        for (glm::vec2 point : edited.gradient.curve.points) separation.add(point.x).add(point.y);
    keys.separation = separation.value();

    const auto levelsKey = [&](synthesis::LevelParams params) {
        Hasher levels;
        const bool followsGradient = params.base == synthesis::LevelBase::Gradient;
        levels.add("levels").add(followsGradient ? keys.separation : keys.strip);
        addParams(levels, params);
        addParams(levels, params.quilt);
        return levels.value();
    };
    keys.levels = levelsKey(project.levels);
    synthesis::LevelParams coarse = project.levels;
    coarse.size = coarseSize;
    keys.coarseLevels = levelsKey(coarse);
    return keys;
}

std::uint64_t Paints::fileKey(const std::filesystem::path& path) {
    const auto known = m_fileKeys.find(path);
    if (known != m_fileKeys.end()) return known->second;
    const QFileInfo file(QString::fromStdString(path.string()));
    Hasher hasher;
    hasher.add("scan").add(path.string()).add(file.size()).add(file.lastModified().toMSecsSinceEpoch());
    return m_fileKeys[path] = hasher.value();
}

}  // namespace chiaro::app
