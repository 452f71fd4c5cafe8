#pragma once

#include "core/project/project.h"

#include <QObject>
#include <QStringList>

#include <filesystem>
#include <functional>

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;
class Paints;
struct JobSpec;
struct LoadedFiles;

/// Brings files into the document: a project replaces it (read-only when its format is newer
/// than this program's), a strip becomes a new sample, a mesh replaces the
/// meshes or joins them. Files are read and checked in the background first; when one can't be used the
/// document stays as it is and the job runner tells why.
class Opener : public QObject {
    Q_OBJECT

public:
    Opener(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes, QObject* parent = nullptr);

    /// Any mixture of projects, strips and meshes; of several projects or meshes the last stays.
    void open(const QStringList& paths) { open(paths, Purpose::Open); }
    /// As open(), but meshes join those that are there.
    void add(const QStringList& paths) { open(paths, Purpose::Add); }
    /// What was kept of a project that was never saved, or of changes to the one at `original`; modified from
    /// the start.
    void recover(const std::filesystem::path& kept, const std::filesystem::path& original);
    /// The sample that a new strip takes the place of, and that a new mesh wears.
    void setCurrentSample(int sample) { m_currentSample = sample; }
    /// Asked before a project replaces a modified one, and again when it was edited while the other was read;
    /// without a question it does.
    void setReplaceQuestion(std::function<bool()> mayReplace) { m_mayReplace = std::move(mayReplace); }
    /// Asked when files of a project are missing; it may name others in their place, and says whether to open
    /// the project with what is still missing left out. Without a question it is not opened.
    void setMissingQuestion(std::function<bool(project::Project&)> findMissing) {
        m_findMissing = std::move(findMissing);
    }
    /// Asked before a project is opened; without a question it always is.
    void setOpenQuestion(std::function<bool(const std::filesystem::path&)> mayOpen) {
        m_mayOpen = std::move(mayOpen);
    }

Q_SIGNALS:
    void projectOpened(const QString& path);
    void sampleOpened(int sample);
    void meshOpened(int firstObject);
    /// Something that is unusual about a file but doesn't keep it from being used.
    void noted(const QString& note);
    void failed(const QString& message);

private:
    enum class Purpose { Open, Add, Recover };
    struct Entry {
        std::filesystem::path path;
        Purpose purpose = Purpose::Open;
        std::filesystem::path original{};  ///< where a recovered project is saved
    };
    void open(const QStringList& paths, Purpose purpose);
    void enqueue(std::vector<Entry> entries);
    void openNext();
    bool mayReplace();
    void openProject(const Entry& entry);
    void readFiles(const Entry& entry, project::ProjectFile file);
    void show(const Entry& entry, LoadedFiles loaded);
    void openStrip(const std::filesystem::path& path);
    void openMesh(const Entry& entry);
    JobSpec spec(const std::filesystem::path& path);
    void note(const std::vector<std::string>& warnings);
    void reportAndGoOn(const QString& message);

    Document& m_document;
    JobRunner& m_jobs;
    Paints& m_paints;
    Meshes& m_meshes;
    std::vector<Entry> m_queue;  ///< the next at the end
    std::function<bool()> m_mayReplace;
    std::function<bool(project::Project&)> m_findMissing;
    std::function<bool(const std::filesystem::path&)> m_mayOpen;
    int m_currentSample = 0;
    bool m_busy = false;
    bool m_isEdited = false;  ///< the document, since the artist was asked
};

}  // namespace chiaro::app
