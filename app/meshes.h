#pragma once

#include "app/change.h"
#include "core/scene/mesh_io.h"
#include "core/scene/scene.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace chiaro::app {

class Document;
class JobRunner;
class Memo;

/// A mesh file's objects as snapshots to share.
struct LoadedModel {
    std::vector<std::shared_ptr<const scene::Mesh>> meshes;
    std::vector<std::string> warnings;
    std::uint64_t contentKey = 0;  ///< hash of the meshes

    /// Throws Error, Cancelled.
    static LoadedModel read(const std::filesystem::path& path, const Task& task);
    std::vector<std::string> objectNames() const;
    std::size_t bytes() const;
};

/// The meshes of the document's mesh file, and the scene that they make with the document's settings. A file
/// that is no longer remembered is read again in the background.
class Meshes : public QObject {
    Q_OBJECT

public:
    Meshes(Document& document, JobRunner& jobs, Memo& memo, QObject* parent = nullptr);

    /// With the document's lights, and who wears which sample.
    scene::Scene scene() const;
    /// Hash of the meshes that the scene is made of; 0 without any.
    std::uint64_t contentKey() const { return m_model ? m_model->contentKey : 0; }
    /// Hands over a model that is already read. To be called before the document names its file.
    void remember(const std::filesystem::path& path, LoadedModel model);

Q_SIGNALS:
    /// Other objects, or the same ones in other paint.
    void sceneChanged();

private:
    void applyChange(Change change);
    void refresh();

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    std::shared_ptr<const LoadedModel> m_model;
};

}  // namespace chiaro::app
