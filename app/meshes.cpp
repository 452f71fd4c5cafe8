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

std::uint64_t contentKeyOf(const std::vector<std::shared_ptr<const scene::Mesh>>& meshes) {
    Hasher hasher;
    for (const auto& mesh : meshes)
        hasher.add(mesh->name)
            .add(std::span<const glm::vec3>(mesh->positions))
            .add(std::span<const glm::vec3>(mesh->normals))
            .add(std::span<const scene::Triangle>(mesh->triangles));
    return hasher.value();
}

}  // namespace

LoadedModel LoadedModel::read(const std::filesystem::path& path, const Task& task) {
    scene::Model model = scene::readModel(path, task);
    LoadedModel loaded;
    for (scene::Mesh& mesh : model.meshes)
        loaded.meshes.push_back(std::make_shared<const scene::Mesh>(std::move(mesh)));
    loaded.warnings = std::move(model.warnings);
    loaded.contentKey = contentKeyOf(loaded.meshes);
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

scene::Scene Meshes::scene() const {
    using List = std::vector<std::shared_ptr<const scene::Mesh>>;
    return project::makeScene(m_document.project(), m_model ? m_model->meshes : List{});
}

void Meshes::remember(const std::filesystem::path& path, LoadedModel model) {
    const std::size_t bytes = model.bytes();
    m_memo.insert(modelKey(path), std::make_shared<const LoadedModel>(std::move(model)), bytes);
}

void Meshes::applyChange(Change change) {
    using Kind = Change::Kind;
    if (change.kind == Kind::Everything || change.kind == Kind::Mesh) refresh();
    if (change.kind == Kind::Samples) Q_EMIT sceneChanged();
}

void Meshes::refresh() {
    const std::filesystem::path path = m_document.project().mesh;
    m_jobs.supersede("mesh");
    if (path.empty() || (m_model = m_memo.find<LoadedModel>(modelKey(path)))) {
        if (path.empty()) m_model = nullptr;
        Q_EMIT sceneChanged();
        return;
    }
    m_jobs.start(
        {tr("Reading %1").arg(QString::fromStdString(path.filename().string())), "mesh", {}, {}},
        [path](const Task& task) { return LoadedModel::read(path, task); },
        [this, path](LoadedModel model) {
            remember(path, std::move(model));
            m_model = m_memo.find<LoadedModel>(modelKey(path));
            Q_EMIT sceneChanged();
        });
}

}  // namespace chiaro::app
