#include "app/meshes.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "core/base/hash.h"
#include "core/project/pipeline.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

std::uint64_t modelKey(const std::filesystem::path& path) {
    return Hasher().add("model").add(path.string()).value();
}

std::uint64_t contentKeyOf(const scene::Mesh& mesh) {
    return Hasher()
        .add(std::span<const glm::vec3>(mesh.positions))
        .add(std::span<const glm::vec3>(mesh.normals))
        .add(std::span<const scene::Triangle>(mesh.triangles))
        .value();
}

}  // namespace

LoadedModel LoadedModel::read(const std::filesystem::path& path, const Task& task) {
    scene::Model model = scene::readModel(path, task);
    LoadedModel loaded;
    for (scene::Mesh& mesh : model.meshes) {
        task.checkpoint();
        loaded.contentKeys.push_back(contentKeyOf(mesh));
        loaded.meshes.push_back(std::make_shared<const scene::Mesh>(std::move(mesh)));
    }
    loaded.warnings = std::move(model.warnings);
    scene::BoundsBuilder bounds;
    for (const auto& mesh : loaded.meshes) {
        task.checkpoint();
        bounds.addMesh(*mesh, glm::mat4(1));
    }
    loaded.radius = bounds.bounds().radius;
    return loaded;
}

std::vector<std::string> LoadedModel::objectNames() const {
    std::vector<std::string> names;
    for (const auto& mesh : meshes) names.push_back(mesh->name);
    return names;
}

std::size_t LoadedModel::bytes() const {
    std::size_t bytes = 0;
    for (const auto& mesh : meshes)
        bytes += (mesh->positions.size() + mesh->normals.size()) * sizeof(glm::vec3) +
                 mesh->triangles.size() * sizeof(scene::Triangle);
    return bytes;
}

Meshes::Meshes(Document& document, JobRunner& jobs, Memo& memo, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_memo(memo) {
    connect(&document, &Document::changed, this, &Meshes::applyChange);
    refresh();
}

void Meshes::update() const {
    if (!std::exchange(m_isStale, false)) return;
    std::vector<project::MeshList> models;
    std::map<const scene::Mesh*, std::uint64_t> keys;
    for (const project::MeshFile& file : m_document.project().meshes) {
        const auto found = m_models.find(file.path);
        const Model model = found == m_models.end() ? nullptr : found->second;
        models.push_back(model ? model->meshes : project::MeshList{});
        for (std::size_t i = 0; i < models.back().size(); ++i)
            keys.emplace(models.back()[i].get(), model->contentKeys[i]);
    }
    m_scene = project::makeScene(m_document.project(), models);
    m_contentKeys.clear();
    for (const scene::Object& object : m_scene.objects)
        m_contentKeys.push_back(object.mesh ? keys.at(object.mesh.get()) : 0);
}

const scene::Scene& Meshes::scene() const {
    update();
    return m_scene;
}

std::uint64_t Meshes::contentKey() const {
    update();
    if (m_contentKeys.empty()) return 0;
    return Hasher().add(std::span<const std::uint64_t>(m_contentKeys)).value();
}

std::uint64_t Meshes::contentKey(int object) const {
    update();
    return m_contentKeys[std::size_t(object)];
}

void Meshes::remember(const std::filesystem::path& path, LoadedModel model) {
    const std::size_t bytes = model.bytes();
    m_unreadable.erase(path);
    m_models[path] = std::make_shared<const LoadedModel>(std::move(model));
    m_memo.insert(modelKey(path), m_models[path], bytes);
}

void Meshes::applyChange(Change change) {
    using Kind = Change::Kind;
    switch (change.kind) {
        case Kind::Everything:
            m_unreadable.clear();
            return refresh();
        case Kind::Mesh:
            return refresh();
        case Kind::Lights:  // who shows them hears of it from the document
            m_isStale = true;
            return;
        case Kind::Samples:
        case Kind::Objects:
        case Kind::Occlusion:
            m_isStale = true;
            Q_EMIT sceneChanged();
            return;
        default:
            return;
    }
}

void Meshes::refresh() {
    m_jobs.supersede("mesh");
    const auto read = std::exchange(m_models, {});
    const std::filesystem::path* unread = nullptr;
    for (const project::MeshFile& mesh : m_document.project().meshes) {
        const auto known = read.find(mesh.path);
        const Model model =
            known != read.end() ? known->second : m_memo.find<LoadedModel>(modelKey(mesh.path));
        if (model)
            m_models.emplace(mesh.path, model);
        else if (!m_unreadable.contains(mesh.path))
            unread = &mesh.path;
    }
    m_isStale = true;
    m_size = 0;
    for (const auto& [path, model] : m_models) m_size = std::max(m_size, model->radius);
    if (!(m_size > 0)) m_size = 1;
    if (unread) this->read(*unread);
    Q_EMIT sceneChanged();
}

void Meshes::read(const std::filesystem::path& path) {
    const auto giveUp = [this, path] {
        m_unreadable.insert(path);
        refresh();
    };
    m_jobs.start(
        {tr("Reading %1").arg(QString::fromStdString(path.filename().string())), "mesh",
         [this, giveUp](const QString& message) {
             Q_EMIT m_jobs.failed(message);
             giveUp();
         },
         giveUp},
        [path](const Task& task) { return LoadedModel::read(path, task); },
        [this, path](LoadedModel model) {
            remember(path, std::move(model));
            refresh();
        });
}

}  // namespace chiaro::app
