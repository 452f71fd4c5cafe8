#include "app/project_files.h"

#include "app/document.h"
#include "app/opener.h"
#include "app/recent_files.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

const char* const projectFilter =
    QT_TRANSLATE_NOOP("chiaro::app::ProjectFiles", "Chiaro projects (*.chiaro)");
const char* const stripFilter =
    QT_TRANSLATE_NOOP("chiaro::app::ProjectFiles", "Strips (*.png *.tif *.tiff *.jpg *.jpeg *.exr *.webp)");
const char* const meshFilter =
    QT_TRANSLATE_NOOP("chiaro::app::ProjectFiles", "Meshes (*.obj *.ply *.off *.stl *.glb *.gltf)");

}  // namespace

ProjectFiles::ProjectFiles(Document& document, Opener& opener, QWidget& window)
    : QObject(&window),
      m_document(document),
      m_opener(opener),
      m_window(window),
      m_recent(new RecentFiles(&window)) {
    connect(m_recent, &RecentFiles::chosen, this, [this](const QString& path) { m_opener.open({path}); });
    connect(&opener, &Opener::projectOpened, this, [this](const QString& path) {
        if (!m_document.path().empty()) m_recent->add(path);
    });
    opener.setReplaceQuestion([this] { return mayDiscard(); });
}

QString ProjectFiles::folder() const {
    if (m_document.path().empty()) return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QString::fromStdString(m_document.path().parent_path().string());
}

void ProjectFiles::newProject() {
    if (mayDiscard()) m_document.replace({}, {}, {});
}

QStringList ProjectFiles::chosen(const QString& title, const QString& filter) const {
    QSettings settings;
    const QString folder = settings.value("folder/" + title).toString();
    const QStringList paths = QFileDialog::getOpenFileNames(&m_window, title, folder, filter);
    if (!paths.isEmpty()) settings.setValue("folder/" + title, QFileInfo(paths.front()).path());
    return paths;
}

void ProjectFiles::open(const QString& title, const QString& filter) {
    if (const QStringList paths = chosen(title, filter); !paths.isEmpty()) m_opener.open(paths);
}

void ProjectFiles::openProject() {
    open(tr("Open Project"), tr(projectFilter));
}

void ProjectFiles::openStrip() {
    open(tr("Open Strip"), tr(stripFilter));
}

void ProjectFiles::openMesh() {
    open(tr("Open Mesh"), tr(meshFilter));
}

void ProjectFiles::addMesh() {
    m_opener.add(chosen(tr("Add Mesh"), tr(meshFilter)));
}

bool ProjectFiles::save() {
    if (m_document.path().empty() || m_document.isReadOnly()) return saveAs();
    return saveTo(QString::fromStdString(m_document.path().string()));
}

bool ProjectFiles::saveAs() {
    const QString name = m_document.isReadOnly() ? tr("%1 copy").arg(m_document.name()) : m_document.name();
    const QString suggestion = folder() + "/" + name + ".chiaro";
    QString path = QFileDialog::getSaveFileName(&m_window, tr("Save Project"), suggestion, tr(projectFilter));
    if (path.isEmpty()) return false;
    if (!path.endsWith(".chiaro")) path += ".chiaro";
    return saveTo(path);
}

bool ProjectFiles::saveTo(const QString& path) {
    const bool wasReadOnly = m_document.isReadOnly();
    try {
        m_document.save(std::filesystem::absolute(path.toStdString()));
    } catch (const std::exception& problem) {
        Q_EMIT failed(QString::fromStdString(problem.what()));
        return false;
    }
    m_recent->add(path);
    Q_EMIT saved();
    if (wasReadOnly)
        Q_EMIT noted(tr("%1 is a copy in this Chiaro's format; what only the newer one knows is not in it.")
                         .arg(QFileInfo(path).fileName()));
    return true;
}

bool ProjectFiles::mayDiscard() {
    if (!m_document.isModified()) return true;
    const auto answer = QMessageBox::question(
        &m_window, tr("Unsaved Changes"), tr("%1 has changes that are not saved.").arg(m_document.name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

}  // namespace chiaro::app
