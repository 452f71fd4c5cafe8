#include "app/autosave.h"

#include "app/document.h"
#include "app/lock_file.h"
#include "core/base/atomic_file.h"

#include <nlohmann/json.hpp>

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largestNote = 1 << 20;

fs::path noteOf(const fs::path& copy) {
    return fs::path(copy).replace_extension(".json");
}

std::unique_ptr<QLockFile> lockOf(const fs::path& copy) {
    return lockAt(fs::path(copy).replace_extension(".lock"));
}

void removeCopy(const fs::path& copy) {
    std::error_code ignored;
    fs::remove(copy, ignored);
    fs::remove(noteOf(copy), ignored);
}

}  // namespace

Autosave::Autosave(Document& document, fs::path folder, Rhythm rhythm, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::move(folder)), m_rhythm(rhythm) {
    m_writer.setMaxThreadCount(1);
    std::error_code ignored;
    fs::create_directories(m_folder, ignored);
    const QString id = QUuid::createUuid().toString(QUuid::WithoutBraces);
    m_copy = m_folder / (id.toStdString() + ".chiaro");
    m_lock = lockOf(m_copy);
    m_lock->tryLock();
    m_soon.setSingleShot(true);
    m_soon.setInterval(int(rhythm.seconds * 1000));
    connect(&m_soon, &QTimer::timeout, this, [this] { keep(); });
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] { ++m_edits; });
    connect(&document, &Document::changed, this, &Autosave::noteEdit);
    connect(&document, &Document::modifiedChanged, this, [this](bool modified) {
        if (!modified) clear();
    });
}

Autosave::~Autosave() {
    m_soon.stop();
    m_writer.waitForDone();
    removeCopy(m_copy);
    m_lock->unlock();
}

void Autosave::noteEdit() {
    if (std::exchange(m_isNoted, true)) return;
    // The undo stack tells whether the document is modified only once the change is done.
    QMetaObject::invokeMethod(this, &Autosave::follow, Qt::QueuedConnection);
}

void Autosave::follow() {
    m_isNoted = false;
    if (!m_document.isModified()) return clear();
    if (!m_hasCopy || m_edits >= m_rhythm.edits) return keep();
    if (!m_soon.isActive()) m_soon.start();
}

void Autosave::keep(std::filesystem::path replaced) {
    m_soon.stop();
    m_edits = 0;
    m_hasCopy = true;
    const nlohmann::json note{{"original", m_document.path().string()},
                              {"name", m_document.name().toStdString()}};
    m_writer.start([this, copy = m_copy, note = note.dump(2), project = m_document.project(),
                    replaced = std::move(replaced)] {
        QString problem;
        try {
            writeFileAtomically(noteOf(copy), note);
            project::writeProject(copy, project);
            if (!replaced.empty()) removeCopy(replaced);
        } catch (const std::exception& error) {
            problem = QString::fromStdString(error.what());
        }
        QMetaObject::invokeMethod(
            this,
            [this, problem, time = QDateTime::currentDateTime()] {
                if (!problem.isEmpty())
                    Q_EMIT failed(problem);
                else if (m_hasCopy)
                    Q_EMIT kept(time);
            },
            Qt::QueuedConnection);
    });
}

void Autosave::clear() {
    m_soon.stop();
    m_edits = 0;
    if (!std::exchange(m_hasCopy, false)) return;
    m_writer.start([copy = m_copy] { removeCopy(copy); });
    Q_EMIT cleared();
}

void Autosave::flush() {
    m_writer.waitForDone();
}

std::vector<Autosave::Leftover> Autosave::leftovers() const {
    std::vector<Leftover> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, error)) {
        const fs::path path = entry.path();
        // Names that begin with a dot are of files that were being written.
        if (path.extension() != ".chiaro" || path == m_copy || path.filename().string().starts_with('.'))
            continue;
        const auto lock = lockOf(path);
        if (!lock->tryLock()) continue;  // its studio runs
        Leftover leftover{.kept = path, .original = {}, .name = tr("Untitled"), .time = {}};
        leftover.time = QFileInfo(QString::fromStdString(path.string())).lastModified();
        try {
            const auto note = nlohmann::json::parse(readFile(noteOf(path), largestNote));
            leftover.original = note.at("original").get<std::string>();
            leftover.name = QString::fromStdString(note.at("name").get<std::string>());
        } catch (const std::exception&) {
            // The note is a convenience: the project is what counts.
        }
        found.push_back(std::move(leftover));
    }
    std::ranges::sort(found, std::greater(), &Leftover::time);
    return found;
}

void Autosave::discard(const Leftover& leftover) {
    m_writer.start([kept = leftover.kept] { removeCopy(kept); });
}

void Autosave::takeOver(const Leftover& leftover) {
    keep(leftover.kept);
}

fs::path Autosave::standardFolder() {
#ifdef Q_OS_LINUX
    QString state = qEnvironmentVariable("XDG_STATE_HOME");
    if (state.isEmpty()) state = QDir::homePath() + "/.local/state";
    state += "/chiaro";
#else
    const QString state = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
#endif
    return fs::path(state.toStdString()) / "autosave";
}

}  // namespace chiaro::app
