#pragma once

#include "app/change.h"
#include "core/project/pipeline.h"
#include "core/scene/mesh_io.h"

#include <QObject>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace chiaro::app {

class Document;
class JobRunner;
class Memo;

/// A mesh file's objects as snapshots to share.
struct LoadedModel {
    project::MeshList meshes;
    std::vector<std::string> warnings;
    std::vector<std::uint64_t> contentKeys;  ///< hash of each mesh
    float radius = 0;                        ///< of all of them where the file puts them

    /// Throws Error, Cancelled.
    static LoadedModel read(const std::filesystem::path& path, const Task& task);
    std::vector<std::string> objectNames() const;
    std::size_t bytes() const;
};

/// The meshes of the document's mesh files, and the scene that they make with the document's settings. Files
/// that are no longer remembered are read again in the background; until then, and where they can't be read,
/// their objects have no mesh.
class Meshes : public QObject {
    Q_OBJECT

public:
    Meshes(Document& document, JobRunner& jobs, Memo& memo, QObject* parent = nullptr);

    /// One object for each of the project's, with the document's lights, and who wears which sample.
    const scene::Scene& scene() const;
    /// Hash of the meshes that the scene is made of, in its order; 0 without any.
    std::uint64_t contentKey() const;
    /// Hash of an object's mesh; 0 while it has none.
    std::uint64_t contentKey(int object) const;
    /// About how large the scene is, from its meshes alone: quick, and the same amid a drag. 1 without any.
    float size() const { return m_size; }
    /// Hands over a model that is already read. To be called before the document names its file.
    void remember(const std::filesystem::path& path, LoadedModel model);

Q_SIGNALS:
    /// Other objects, or the same ones in other paint or places.
    void sceneChanged();

private:
    void applyChange(Change change);
    void refresh();
    void read(const std::filesystem::path& path);
    void update() const;

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    using Model = std::shared_ptr<const LoadedModel>;
    std::map<std::filesystem::path, Model> m_models;  ///< of the mesh files that are read
    std::set<std::filesystem::path> m_unreadable;     ///< not tried again by itself
    // The scene is asked for often and changes seldom.
    float m_size = 1;
    mutable scene::Scene m_scene;
    mutable std::vector<std::uint64_t> m_contentKeys;  ///< one an object
    mutable bool m_isStale = true;
};

}  // namespace chiaro::app
