#include "app/opener.h"

#include "app/document.h"
#include "app/file_kind.h"
#include "app/jobs/job_runner.h"
#include "app/meshes.h"
#include "app/paints.h"
#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/project/objects.h"

#include <QtWidgets>

#include <map>

namespace chiaro::app {

/// A project and the files that it names, all read but those that are missing.
struct LoadedFiles {
    project::Project project;
    std::map<std::filesystem::path, LoadedScan> scans;
    std::map<std::filesystem::path, LoadedModel> models;
    std::vector<std::string> warnings;
    bool isRelinked = false;  ///< its files are not those that it was saved with
    int version = project::Project::version;
};

namespace {

LoadedFiles readAll(project::Project project, const Task& task) {
    LoadedFiles loaded{.project = std::move(project), .scans = {}, .models = {}, .warnings = {}};
    const std::vector<project::MissingFile> missing = project::missingFiles(loaded.project);
    const auto isMissing = [&](const std::filesystem::path& path) {
        return std::ranges::find(missing, path, &project::MissingFile::path) != missing.end();
    };
    const std::size_t count = loaded.project.samples.size() + loaded.project.meshes.size();
    std::size_t number = 0;
    const auto next = [&] {
        task.checkpoint();
        ++number;
        return task.part(double(number - 1) / double(count), double(number) / double(count));
    };
    for (const project::Sample& sample : loaded.project.samples) {
        next().report(0);
        if (!isMissing(sample.scan)) loaded.scans.emplace(sample.scan, LoadedScan::read(sample.scan));
    }
    for (const project::MeshFile& mesh : loaded.project.meshes) {
        const Task part = next();
        if (isMissing(mesh.path) || loaded.models.contains(mesh.path)) continue;
        const auto [model, isNew] = loaded.models.emplace(mesh.path, LoadedModel::read(mesh.path, part));
        const auto& warnings = model->second.warnings;
        loaded.warnings.insert(loaded.warnings.end(), warnings.begin(), warnings.end());
    }
    return loaded;
}

project::ObjectNames namesIn(const LoadedFiles& loaded) {
    project::ObjectNames names;
    for (const project::MeshFile& mesh : loaded.project.meshes) {
        const auto model = loaded.models.find(mesh.path);
        names.push_back(model == loaded.models.end() ? std::vector<std::string>{}
                                                     : model->second.objectNames());
    }
    return names;
}

/// The demo is opened to play with: saving asks for a place, and the demo stays as it is.
bool isDemo(const std::filesystem::path& path) {
    try {
        return std::filesystem::equivalent(path.parent_path(), resourceFolder() / "demo");
    } catch (const std::exception&) {
        return false;  // no demo there
    }
}

/// What to say of a mesh that is lost in the scene that it joins, or the other way around; empty else.
QString sizeNote(const LoadedModel& model, float size) {
    constexpr float striking = 15;
    const float ratio = model.radius / size;
    if (!(ratio > 0) || !std::isfinite(ratio) || (ratio < striking && ratio > 1 / striking)) return {};
    return ratio > 1 ? Opener::tr(
                           "The added mesh is %1 times as large as the rest; its Scale in the Scene dock "
                           "fits it in.")
                           .arg(qRound(ratio))
                     : Opener::tr(
                           "The rest is %1 times as large as the added mesh; its Scale in the Scene dock "
                           "fits it in.")
                           .arg(qRound(1 / ratio));
}

QString fileName(const std::filesystem::path& path) {
    return QString::fromStdString(path.filename().string());
}

}  // namespace

Opener::Opener(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_paints(paints), m_meshes(meshes) {
    connect(&document, &Document::changed, this, [this] { m_isEdited = true; });
}

void Opener::open(const QStringList& paths, Purpose purpose) {
    std::vector<Entry> entries;
    for (const QString& path : paths)
        entries.push_back({std::filesystem::absolute(std::filesystem::path(path.toStdString())), purpose});
    enqueue(std::move(entries));
}

void Opener::recover(const std::filesystem::path& kept, const std::filesystem::path& original) {
    enqueue({{kept, Purpose::Recover, original}});
}

void Opener::enqueue(std::vector<Entry> entries) {
    // The queue is taken from its end.
    m_queue.insert(m_queue.begin(), entries.rbegin(), entries.rend());
    if (!m_busy) openNext();
}

void Opener::openNext() {
    m_busy = !m_queue.empty();
    if (!m_busy) return;
    const Entry entry = m_queue.back();
    m_queue.pop_back();
    try {
        switch (fileKind(entry.path)) {
            case FileKind::Project:
                return openProject(entry);
            case FileKind::Strip:
                return openStrip(entry.path);
            case FileKind::Mesh:
                return openMesh(entry);
        }
    } catch (const std::exception& problem) {
        reportAndGoOn(QString::fromStdString(problem.what()));
    }
}

JobSpec Opener::spec(const std::filesystem::path& path) {
    return {tr("Opening %1").arg(fileName(path)), "open",
            [this](const QString& message) { reportAndGoOn(message); }, [this] { openNext(); }};
}

void Opener::reportAndGoOn(const QString& message) {
    Q_EMIT failed(message);
    openNext();
}

bool Opener::mayReplace() {
    if (m_document.isModified() && m_mayReplace && !m_mayReplace()) return false;
    m_isEdited = false;
    return true;
}

void Opener::openProject(const Entry& entry) {
    if (!mayReplace()) return openNext();
    if (entry.purpose != Purpose::Recover && m_mayOpen && !m_mayOpen(entry.path)) return openNext();
    m_jobs.start(
        spec(entry.path), [path = entry.path](const Task&) { return project::readProjectFile(path); },
        [this, entry](project::ProjectFile file) { readFiles(entry, std::move(file)); });
}

void Opener::readFiles(const Entry& entry, project::ProjectFile file) {
    project::Project& project = file.project;
    const std::vector<project::MissingFile> missing = project::missingFiles(project);
    const project::Project saved = project;
    if (!missing.empty() && !m_findMissing) {
        const Error error(missing.front().path.string(), "is not there",
                          "the project needs it; put it back or open the project where it can be found");
        return reportAndGoOn(QString::fromStdString(error.what()));
    }
    if (!missing.empty() && !m_findMissing(project)) return openNext();
    const bool isRelinked = project != saved;
    m_jobs.start(
        spec(entry.path), [project = std::move(project)](const Task& task) { return readAll(project, task); },
        [this, entry, isRelinked, version = file.version](LoadedFiles loaded) {
            loaded.isRelinked = isRelinked;
            loaded.version = version;
            show(entry, std::move(loaded));
        });
}

void Opener::show(const Entry& entry, LoadedFiles loaded) {
    // Artists go on while files are read: what they did since they were asked is theirs to keep.
    if (m_isEdited && !mayReplace()) return openNext();
    const project::ObjectNames names = namesIn(loaded);
    for (auto& [path, scan] : loaded.scans) m_paints.remember(path, std::move(scan));
    for (auto& [path, model] : loaded.models) m_meshes.remember(path, std::move(model));
    const bool isRecovered = entry.purpose == Purpose::Recover;
    const std::filesystem::path path = isRecovered ? entry.original : entry.path;
    const std::filesystem::path place = isDemo(path) ? std::filesystem::path() : path;
    if (isRecovered || loaded.isRelinked)
        m_document.recover(std::move(loaded.project), place, names);
    else
        m_document.replace(std::move(loaded.project), place, names);
    if (loaded.version > project::Project::version) {
        m_document.setReadOnly();
        loaded.warnings.insert(
            loaded.warnings.begin(),
            tr("%1 was written by a newer Chiaro (format %2, this one writes %3) and is "
               "open read-only; Save As makes a copy without what only the newer one knows.")
                .arg(fileName(path))
                .arg(loaded.version)
                .arg(project::Project::version)
                .toStdString());
    }
    Q_EMIT projectOpened(QString::fromStdString(path.string()));
    note(loaded.warnings);
    openNext();
}

void Opener::openStrip(const std::filesystem::path& path) {
    m_jobs.start(
        spec(path), [path](const Task&) { return LoadedScan::read(path); },
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

void Opener::openMesh(const Entry& entry) {
    const std::filesystem::path path = entry.path;
    m_jobs.start(
        spec(path), [path](const Task& task) { return LoadedModel::read(path, task); },
        [this, path, adds = entry.purpose == Purpose::Add](LoadedModel model) {
            const std::vector<std::string> names = model.objectNames();
            std::vector<std::string> warnings = model.warnings;
            if (const QString size = sizeNote(model, m_meshes.size());
                adds && !m_document.project().meshes.empty() && !size.isEmpty())
                warnings.push_back(size.toStdString());
            m_meshes.remember(path, std::move(model));
            int first = 0;
            if (adds)
                first = m_document.addMesh(path, names, m_currentSample);
            else
                m_document.setMesh(path, names, m_currentSample);
            Q_EMIT meshOpened(first);
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
