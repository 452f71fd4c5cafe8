#include "app/opener.h"

#include "app/document.h"
#include "app/file_kind.h"
#include "app/jobs/job_runner.h"
#include "app/meshes.h"
#include "app/paints.h"
#include "core/base/error.h"
#include "core/base/resources.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

/// A project and the files that it names, all read.
struct LoadedProject {
    project::Project project;
    std::vector<LoadedScan> scans;
    LoadedModel model;
};

LoadedProject readAll(const std::filesystem::path& path, const Task& task) {
    LoadedProject loaded{project::readProject(path), {}, {}};
    const auto& samples = loaded.project.samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        task.checkpoint();
        loaded.scans.push_back(LoadedScan::read(samples[i].scan));
        task.report(0.5 * double(i + 1) / double(samples.size()));
    }
    if (!loaded.project.mesh.empty())
        loaded.model = LoadedModel::read(loaded.project.mesh, task.part(0.5, 1));
    return loaded;
}

/// The demo is opened to play with: saving asks for a place, and the demo stays as it is.
bool isDemo(const std::filesystem::path& path) {
    try {
        return std::filesystem::equivalent(path.parent_path(), resourceFolder() / "demo");
    } catch (const std::exception&) {
        return false;  // no demo there
    }
}

QString fileName(const std::filesystem::path& path) {
    return QString::fromStdString(path.filename().string());
}

}  // namespace

Opener::Opener(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_paints(paints), m_meshes(meshes) {}

void Opener::open(const QStringList& paths) {
    std::vector<std::filesystem::path> files;
    for (const QString& path : paths)
        files.push_back(std::filesystem::absolute(std::filesystem::path(path.toStdString())));
    // The queue is taken from its end.
    std::reverse(files.begin(), files.end());
    m_queue.insert(m_queue.begin(), files.begin(), files.end());
    if (!m_busy) openNext();
}

void Opener::openNext() {
    m_busy = !m_queue.empty();
    if (!m_busy) return;
    const std::filesystem::path path = m_queue.back();
    m_queue.pop_back();
    try {
        switch (fileKind(path)) {
            case FileKind::Project:
                return openProject(path);
            case FileKind::Strip:
                return openStrip(path);
            case FileKind::Mesh:
                return openMesh(path);
        }
    } catch (const std::exception& problem) {
        reportAndGoOn(QString::fromStdString(problem.what()));
    }
}

void Opener::reportAndGoOn(const QString& message) {
    Q_EMIT failed(message);
    openNext();
}

void Opener::openProject(const std::filesystem::path& path) {
    if (m_document.isModified() && m_mayReplace && !m_mayReplace()) return openNext();
    m_jobs.start(
        {tr("Opening %1").arg(fileName(path)), "open",
         [this](const QString& message) { reportAndGoOn(message); }, [this] { openNext(); }},
        [path](const Task& task) { return readAll(path, task); },
        [this, path](LoadedProject loaded) {
            for (std::size_t i = 0; i < loaded.scans.size(); ++i)
                m_paints.remember(loaded.project.samples[i].scan, std::move(loaded.scans[i]));
            const std::vector<std::string> names = loaded.model.objectNames();
            const std::vector<std::string> warnings = loaded.model.warnings;
            if (!loaded.project.mesh.empty()) m_meshes.remember(loaded.project.mesh, std::move(loaded.model));
            m_document.replace(std::move(loaded.project), isDemo(path) ? std::filesystem::path() : path,
                               names);
            Q_EMIT projectOpened(QString::fromStdString(path.string()));
            note(warnings);
            openNext();
        });
}

void Opener::openStrip(const std::filesystem::path& path) {
    m_jobs.start(
        {tr("Opening %1").arg(fileName(path)), "open",
         [this](const QString& message) { reportAndGoOn(message); }, [this] { openNext(); }},
        [path](const Task&) { return LoadedScan::read(path); },
        [this, path](LoadedScan scan) {
            m_paints.remember(path, std::move(scan));
            project::Sample opened;
            opened.name = path.stem().string();
            opened.scan = path;
            const int sample = m_document.addSample(opened, m_currentSample);
            Q_EMIT sampleOpened(sample);
            openNext();
        });
}

void Opener::openMesh(const std::filesystem::path& path) {
    m_jobs.start(
        {tr("Opening %1").arg(fileName(path)), "open",
         [this](const QString& message) { reportAndGoOn(message); }, [this] { openNext(); }},
        [path](const Task& task) { return LoadedModel::read(path, task); },
        [this, path](LoadedModel model) {
            const std::vector<std::string> names = model.objectNames();
            const std::vector<std::string> warnings = model.warnings;
            m_meshes.remember(path, std::move(model));
            m_document.setMesh(path, names, m_currentSample);
            Q_EMIT meshOpened();
            note(warnings);
            openNext();
        });
}

void Opener::note(const std::vector<std::string>& warnings) {
    QStringList lines;
    for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
    if (!lines.isEmpty()) Q_EMIT noted(lines.join('\n'));
}

}  // namespace chiaro::app
