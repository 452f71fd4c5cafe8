#include "app/document.h"

#include "app/commands/change_value.h"

#include <QtWidgets>

#include <algorithm>
#include <optional>

namespace chiaro::app {

Document::Document(QObject* parent) : QObject(parent) {
    connect(&m_undo, &QUndoStack::cleanChanged, this, [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

QString Document::name() const {
    return m_path.empty() ? tr("Untitled") : QString::fromStdString(m_path.stem().string());
}

void Document::replace(project::Project project, const std::filesystem::path& path,
                       const std::vector<std::string>& objectNames) {
    m_project = std::move(project);
    m_objectNames = objectNames;
    m_path = path;
    m_editing = false;
    m_undo.clear();
    m_undo.setClean();
    Q_EMIT pathChanged();
    Q_EMIT changed({Change::Kind::Everything});
}

void Document::save(const std::filesystem::path& path) {
    project::writeProject(path, m_project);
    m_path = path;
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
    if (command->changesNothing()) return;
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

void Document::editLight(int light, glm::vec3 vector) {
    std::vector<scene::Light> lights = m_project.lights;
    lights[std::size_t(light)].vector = vector;
    edit(
        {Change::Kind::Lights}, tr("Turn Light"), [](auto& project) -> auto& { return project.lights; },
        lights);
}

void Document::editViews(const views::ViewParams& params) {
    edit(
        {Change::Kind::Views}, tr("Change View Planning"),
        [](auto& project) -> auto& { return project.views; }, params);
}

const std::vector<project::PlacedView>& Document::placedViews(int object) const {
    static const std::vector<project::PlacedView> none;
    if (object < 0 || object >= int(m_objectNames.size())) return none;
    const auto found = std::ranges::find(m_project.objects, m_objectNames[std::size_t(object)],
                                         &project::ObjectSettings::name);
    return found == m_project.objects.end() ? none : found->views;
}

void Document::editPlacedViews(int object, const QString& text, std::vector<project::PlacedView> views) {
    const std::string& name = m_objectNames[std::size_t(object)];
    std::vector<project::ObjectSettings> objects = m_project.objects;
    auto found = std::ranges::find(objects, name, &project::ObjectSettings::name);
    if (found == objects.end()) found = objects.insert(found, {.name = name});
    found->views = std::move(views);
    edit(
        {Change::Kind::PlacedViews, object}, text, [](auto& project) -> auto& { return project.objects; },
        objects);
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
    return {m_project.samples, m_project.mesh, m_project.objects, m_objectNames};
}

void Document::editContents(Change::Kind kind, const QString& text, const Contents& contents) {
    finishEdit();
    using Command = ChangeValue<Contents>;
    const Command::Access access{[this](const project::Project&) { return this->contents(); },
                                 [this](project::Project& project, const Contents& changed) {
                                     project.samples = changed.samples;
                                     project.mesh = changed.mesh;
                                     project.objects = changed.objects;
                                     m_objectNames = changed.objectNames;
                                 }};
    auto command = std::make_unique<Command>(*this, Change{kind}, text, m_session, access, contents);
    if (!command->changesNothing()) m_undo.push(command.release());
    finishEdit();
}

std::vector<project::ObjectSettings> Document::allObjects() const {
    std::vector<project::ObjectSettings> objects = m_project.objects;
    for (const std::string& name : m_objectNames) {
        const auto named = [&](const project::ObjectSettings& object) { return object.name == name; };
        if (std::none_of(objects.begin(), objects.end(), named)) objects.push_back({.name = name});
    }
    return objects;
}

bool Document::isWorn(int sample) const {
    const std::vector<project::ObjectSettings> objects = allObjects();
    return std::any_of(m_objectNames.begin(), m_objectNames.end(), [&](const std::string& name) {
        const auto named = [&](const project::ObjectSettings& object) { return object.name == name; };
        const auto object = std::find_if(objects.begin(), objects.end(), named);
        return object->visible && object->sample == sample;
    });
}

int Document::addSample(const project::Sample& sample, int instead) {
    Contents next = contents();
    const int index = int(next.samples.size());
    next.samples.push_back(sample);
    if (index > 0) next.objects = allObjects();
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

void Document::wearEverywhere(int sample) {
    Contents next = contents();
    next.objects = allObjects();
    for (project::ObjectSettings& object : next.objects) object.sample = sample;
    editContents(Change::Kind::Samples, tr("Paint Everything"), next);
}

void Document::setMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames,
                       int sample) {
    Contents next = contents();
    next.mesh = path;
    next.objectNames = objectNames;
    next.objects.clear();
    for (const std::string& name : objectNames) next.objects.push_back({.name = name, .sample = sample});
    editContents(Change::Kind::Mesh, tr("Open Mesh"), next);
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
