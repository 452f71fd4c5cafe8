#pragma once

#include <QObject>
#include <QStringList>

#include <filesystem>
#include <functional>

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;
class Paints;

/// Brings files into the document: a project replaces it, a strip becomes a new sample, a mesh replaces the
/// mesh. Files are read and checked in the background first; when one can't be used the document stays as it
/// is and the job runner tells why.
class Opener : public QObject {
    Q_OBJECT

public:
    Opener(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes, QObject* parent = nullptr);

    /// Any mixture of projects, strips and meshes; of several projects or meshes the last stays.
    void open(const QStringList& paths);
    /// The sample that a new strip takes the place of, and that a new mesh wears.
    void setCurrentSample(int sample) { m_currentSample = sample; }
    /// Asked before a project replaces a modified one; without a question it does.
    void setReplaceQuestion(std::function<bool()> mayReplace) { m_mayReplace = std::move(mayReplace); }

Q_SIGNALS:
    void projectOpened(const QString& path);
    void sampleOpened(int sample);
    void meshOpened();
    /// Something that is unusual about a file but doesn't keep it from being used.
    void noted(const QString& note);
    void failed(const QString& message);

private:
    void openNext();
    void openProject(const std::filesystem::path& path);
    void openStrip(const std::filesystem::path& path);
    void openMesh(const std::filesystem::path& path);
    void note(const std::vector<std::string>& warnings);
    void reportAndGoOn(const QString& message);

    Document& m_document;
    JobRunner& m_jobs;
    Paints& m_paints;
    Meshes& m_meshes;
    std::vector<std::filesystem::path> m_queue;  ///< the next at the end
    std::function<bool()> m_mayReplace;
    int m_currentSample = 0;
    bool m_busy = false;
};

}  // namespace chiaro::app
