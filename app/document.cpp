#include "app/document.h"

#include "app/commands/change_value.h"
#include "core/project/backups.h"
#include "core/project/render_method.h"

#include <QtWidgets>

#include <algorithm>
#include <optional>
#include <set>

namespace chiaro::app {

Document::Document(QObject* parent) : QObject(parent) {
    connect(&m_undo, &QUndoStack::cleanChanged, this, [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

QString Document::name() const {
    return m_path.empty() ? tr("Untitled") : QString::fromStdString(m_path.stem().string());
}

void Document::replace(project::Project project, const std::filesystem::path& path,
                       const project::ObjectNames& names) {
    m_project = std::move(project);
    m_project.objects = project::allObjects(m_project, names);
    m_path = path;
    m_isReadOnly = false;
    m_editing = false;
    m_undo.clear();
    m_undo.setClean();
    Q_EMIT pathChanged();
    Q_EMIT changed({Change::Kind::Everything});
}

void Document::recover(project::Project project, const std::filesystem::path& path,
                       const project::ObjectNames& names) {
    replace(std::move(project), path, names);
    m_undo.resetClean();
}

void Document::setReadOnly() {
    m_isReadOnly = true;
    Q_EMIT pathChanged();
}

void Document::save(const std::filesystem::path& path) {
    project::refuseToReplaceNewer(path);
    project::removeLeftovers(path);
    project::keepBackup(path);
    project::writeProject(path, m_project);
    m_path = path;
    m_isReadOnly = false;
    m_undo.setClean();
    Q_EMIT pathChanged();
}

template <class Value, class Member>
void Document::edit(Change change, const QString& text, Member member, const Value& value) {
    using Command = ChangeValue<Value>;
    const typename Command::Access access{
        [member](const project::Project& project) -> Value { return member(project); },
        [member](project::Project& project, const Value& changed) { member(project) = changed; }};
    auto command = std::make_unique<Command>(*this, change, text, m_session, access, value);
    if (m_isTelling || command->changesNothing()) return;
    m_editing = true;
    m_undo.push(command.release());
}

void Document::editStrip(int sample, const sample::StripParams& params) {
    edit(
        {Change::Kind::Strip, sample}, tr("Cut Strip"),
        [sample](auto& project) -> auto& { return project.samples[std::size_t(sample)].strip; }, params);
}

void Document::editGradient(int sample, const gradient::GradientParams& params) {
    edit(
        {Change::Kind::Gradient, sample}, tr("Change Gradient"),
        [sample](auto& project) -> auto& { return project.samples[std::size_t(sample)].gradient; }, params);
}

void Document::editRecoloring(int sample, const std::optional<gradient::ColorPath>& path) {
    edit(
        {Change::Kind::Recoloring, sample}, tr("Recolour"),
        [sample](auto& project) -> auto& { return project.samples[std::size_t(sample)].recoloring; }, path);
}

void Document::editLevels(const synthesis::LevelParams& params) {
    edit(
        {Change::Kind::Levels}, tr("Change Levels"), [](auto& project) -> auto& { return project.levels; },
        params);
}

void Document::editViewAligned(const methods::ViewAlignedParams& params) {
    edit(
        {Change::Kind::ViewAligned}, tr("Change Strokes"),
        [](auto& project) -> auto& { return project.viewAligned; }, params);
}

void Document::editMethod(const std::string& key) {
    edit(
        {Change::Kind::Method}, tr("Change Method"), [](auto& project) -> auto& { return project.method; },
        key);
}

void Document::editImageBased(const methods::ImageBasedParams& params) {
    edit(
        {Change::Kind::ImageBased}, tr("Change Synthesis"),
        [](auto& project) -> auto& { return project.imageBased; }, params);
}

void Document::editCoherence(const methods::CoherenceParams& params) {
    edit(
        {Change::Kind::Coherence}, tr("Change Coherence"),
        [](auto& project) -> auto& { return project.coherence; }, params);
}

void Document::editViewDependent(const methods::ViewDependentParams& params) {
    edit(
        {Change::Kind::ViewDependent}, tr("Change Blending"),
        [](auto& project) -> auto& { return project.viewDependent; }, params);
}

void Document::editOcclusion(const scene::OcclusionParams& params) {
    edit(
        {Change::Kind::Occlusion}, tr("Change Shadows"),
        [](auto& project) -> auto& { return project.occlusion; }, params);
}

void Document::editLight(int light, glm::vec3 vector) {
    if (m_isTelling) return;
    std::vector<scene::Light> lights = m_project.lights;
    scene::Light& one = lights[std::size_t(light)];
    one.vector = vector;
    editLights(lights, one.kind == scene::Light::Kind::Point ? tr("Move Light") : tr("Turn Light"));
}

void Document::editLights(const std::vector<scene::Light>& lights, const QString& text) {
    edit(
        {Change::Kind::Lights}, text, [](auto& project) -> auto& { return project.lights; }, lights);
}

void Document::editTogether(const QString& text, const std::function<void()>& edits) {
    finishEdit();
    m_undo.beginMacro(text);
    edits();
    m_undo.endMacro();
    finishEdit();
}

void Document::applyPreset(const project::MethodPreset& preset) {
    project::MethodParams params = project::MethodParams::of(m_project);
    preset.applyTo(params);
    if (params == project::MethodParams::of(m_project)) return;
    editTogether(tr("Apply Preset"), [&] {
        editLevels(params.levels);
        editViewAligned(params.viewAligned);
        editImageBased(params.imageBased);
        editCoherence(params.coherence);
        editViewDependent(params.viewDependent);
        editViews(params.views);
    });
}

void Document::applyPreset(int object, const project::ViewPlanPreset& preset) {
    if (preset.params == m_project.views && preset.placed == placedViews(object)) return;
    editTogether(tr("Apply Preset"), [&] {
        editViews(preset.params);
        editPlacedViews(object, tr("Place Views"), preset.placed);
    });
}

void Document::editAnimation(const project::Animation& animation, const QString& text) {
    edit(
        {Change::Kind::Animation}, text, [](auto& project) -> auto& { return project.animation; }, animation);
}

void Document::editViews(const views::ViewParams& params) {
    edit(
        {Change::Kind::Views}, tr("Change View Planning"),
        [](auto& project) -> auto& { return project.views; }, params);
}

const std::vector<project::PlacedView>& Document::placedViews(int object) const {
    static const std::vector<project::PlacedView> none;
    if (object < 0 || object >= int(m_project.objects.size())) return none;
    return m_project.objects[std::size_t(object)].views;
}

void Document::editPlacedViews(int object, const QString& text, std::vector<project::PlacedView> views) {
    edit(
        {Change::Kind::PlacedViews, object},
        text, [object](auto& project) -> auto& { return project.objects[std::size_t(object)].views; }, views);
}

int Document::addView(int object, const project::PlacedView& view) {
    std::vector<project::PlacedView> views = placedViews(object);
    views.push_back(view);
    editPlacedViews(object, tr("Add View"), views);
    return int(views.size()) - 1;
}

int Document::lockView(int object, const project::PlacedView& view) {
    std::vector<project::PlacedView> views = placedViews(object);
    views.push_back(view);
    editPlacedViews(object, tr("Lock View"), views);
    return int(views.size()) - 1;
}

void Document::moveView(int object, int view, const project::PlacedView& moved) {
    std::vector<project::PlacedView> views = placedViews(object);
    views[std::size_t(view)] = moved;
    editPlacedViews(object, tr("Move View"), std::move(views));
}

void Document::removeView(int object, int view) {
    std::vector<project::PlacedView> views = placedViews(object);
    views.erase(views.begin() + view);
    editPlacedViews(object, tr("Remove View"), std::move(views));
}

Document::Contents Document::contents() const {
    return {m_project.samples, m_project.meshes, m_project.objects};
}

void Document::editContents(Change::Kind kind, const QString& text, const Contents& contents) {
    finishEdit();
    using Command = ChangeValue<Contents>;
    const Command::Access access{[this](const project::Project&) { return this->contents(); },
                                 [this](project::Project& project, const Contents& changed) {
                                     project.samples = changed.samples;
                                     project.meshes = changed.meshes;
                                     project.objects = changed.objects;
                                 }};
    auto command = std::make_unique<Command>(*this, Change{kind}, text, m_session, access, contents);
    if (!m_isTelling && !command->changesNothing()) m_undo.push(command.release());
    finishEdit();
}

bool Document::isWorn(int sample) const {
    return std::ranges::any_of(m_project.objects, [&](const project::ObjectSettings& object) {
        return object.visible && object.sample == sample;
    });
}

void Document::editObjects(std::vector<project::ObjectSettings> objects, const QString& text) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        project::ObjectSettings& object = objects[i];
        const std::string& before = m_project.objects[i].name;
        if (object.name == before) continue;
        if (object.source.empty()) object.source = before;
        std::vector<project::ObjectSettings> others = objects;
        others.erase(others.begin() + std::ptrdiff_t(i));
        object.name = project::uniqueName(object.name, others);
        if (object.source == object.name) object.source.clear();
    }
    edit(
        {Change::Kind::Objects}, text, [](auto& project) -> auto& { return project.objects; }, objects);
}

void Document::removeObjects(const std::vector<int>& objects) {
    Contents next = contents();
    const std::set<int> removed(objects.begin(), objects.end());
    using Source = std::pair<int, std::string>;
    const auto sourceOf = [](const project::ObjectSettings& object) {
        return Source(object.mesh, object.sourceName());
    };
    std::set<Source> left;  // what the scene still has, or the file was told to leave out
    next.objects.clear();
    for (int object = 0; object < int(m_project.objects.size()); ++object) {
        if (removed.contains(object)) continue;
        next.objects.push_back(m_project.objects[std::size_t(object)]);
        left.insert(sourceOf(next.objects.back()));
    }
    for (const int object : removed) {
        const Source source = sourceOf(m_project.objects[std::size_t(object)]);
        if (left.insert(source).second)
            next.meshes[std::size_t(source.first)].without.push_back(source.second);
    }
    std::set<int> filesLeft;
    for (const project::ObjectSettings& object : next.objects) filesLeft.insert(object.mesh);
    for (int file = int(next.meshes.size()) - 1; file >= 0; --file) {
        if (filesLeft.contains(file)) continue;
        next.meshes.erase(next.meshes.begin() + file);
        for (project::ObjectSettings& object : next.objects) object.mesh -= object.mesh > file ? 1 : 0;
    }
    editContents(next.meshes == m_project.meshes ? Change::Kind::Objects : Change::Kind::Mesh,
                 objects.size() == 1 ? tr("Remove Object") : tr("Remove Objects"), next);
}

std::vector<int> Document::duplicateObjects(const std::vector<int>& objects) {
    Contents next = contents();
    std::vector<int> copies;
    std::vector<int> first(objects);
    std::ranges::sort(first);
    project::UniqueNames names(next.objects);
    next.objects.clear();
    auto duplicated = first.begin();
    for (int object = 0; object < int(m_project.objects.size()); ++object) {
        const project::ObjectSettings& original = m_project.objects[std::size_t(object)];
        next.objects.push_back(original);
        if (duplicated == first.end() || *duplicated != object) continue;
        ++duplicated;
        copies.push_back(int(next.objects.size()));
        project::ObjectSettings& copy = next.objects.emplace_back(original);
        copy.source = original.sourceName();
        copy.name = names.take(original.name);
    }
    editContents(Change::Kind::Objects, tr("Duplicate"), next);
    return copies;
}

int Document::addSample(const project::Sample& sample, int instead) {
    Contents next = contents();
    const int index = int(next.samples.size());
    next.samples.push_back(sample);
    for (project::ObjectSettings& object : next.objects)
        if (object.sample == instead || index == 0) object.sample = index;
    editContents(Change::Kind::Samples, tr("Add Sample"), next);
    return index;
}

void Document::removeSample(int sample) {
    Contents next = contents();
    next.samples.erase(next.samples.begin() + sample);
    for (project::ObjectSettings& object : next.objects)
        object.sample = object.sample == sample ? 0 : object.sample - (object.sample > sample ? 1 : 0);
    editContents(Change::Kind::Samples, tr("Remove Sample"), next);
}

void Document::renameSample(int sample, const std::string& name) {
    Contents next = contents();
    next.samples[std::size_t(sample)].name = name;
    editContents(Change::Kind::Samples, tr("Rename Sample"), next);
}

void Document::wearEverywhere(int sample) {
    Contents next = contents();
    for (project::ObjectSettings& object : next.objects) object.sample = sample;
    editContents(Change::Kind::Samples, tr("Paint Everything"), next);
}

void Document::setMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames,
                       int sample) {
    Contents next = contents();
    next.meshes = {{path}};
    next.objects.clear();
    for (const std::string& name : objectNames) next.objects.push_back({.name = name, .sample = sample});
    editContents(Change::Kind::Mesh, tr("Open Mesh"), next);
}

int Document::addMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames,
                      int sample) {
    Contents next = contents();
    const int file = int(next.meshes.size()), first = int(next.objects.size());
    next.meshes.push_back({path});
    project::UniqueNames names(next.objects);
    for (const std::string& source : objectNames) {
        const std::string name = names.take(source);
        next.objects.push_back({.name = name, .source = source, .mesh = file, .sample = sample});
        if (name == source) next.objects.back().source.clear();
    }
    editContents(Change::Kind::Mesh, tr("Add Mesh"), next);
    return first;
}

void Document::setComparedMethods(std::vector<std::string> keys) {
    if (keys == m_comparedMethods) return;
    m_comparedMethods = std::move(keys);
    Q_EMIT changed({Change::Kind::Method});
}

bool Document::shows(std::string_view method) const {
    if (m_comparedMethods.empty()) return m_project.method == method;
    return std::ranges::find(m_comparedMethods, method) != m_comparedMethods.end();
}

bool Document::shows(bool project::RenderMethod::*need) const {
    return std::ranges::any_of(project::renderMethods(), [&](const project::RenderMethod& method) {
        return method.*need && shows(method.key);
    });
}

void Document::finishEdit() {
    ++m_session;
    if (!m_editing) return;
    m_editing = false;
    Q_EMIT editFinished();
}

void Document::setCamera(const scene::Camera& camera) {
    m_project.camera = camera;
    m_project.frameCamera = false;
}

}  // namespace chiaro::app
