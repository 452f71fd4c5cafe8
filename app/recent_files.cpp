#include "app/recent_files.h"

#include "app/project_pictures.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int maximumFiles = 10;
constexpr const char* settingsKey = "recentFiles";

QIcon pictureOf(const QString& path) {
    const QImage picture = ProjectPictures::find(path);
    QPixmap pixmap(ProjectPictures::size * 2);
    pixmap.fill(Qt::transparent);
    if (!picture.isNull()) pixmap = QPixmap::fromImage(picture);
    return QIcon(pixmap);
}

}  // namespace

RecentFiles::RecentFiles(QWidget* parent) : QMenu(tr("Open &Recent"), parent) {
    // The style's small icons are too small for a picture.
    setStyleSheet(QString("QMenu { icon-size: %1px; }").arg(ProjectPictures::size.width()));
    connect(this, &QMenu::aboutToShow, this, &RecentFiles::rebuild);
    rebuild();
}

void RecentFiles::add(const QString& path) {
    QStringList files = QSettings().value(settingsKey).toStringList();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(settingsKey, QStringList(files.mid(0, maximumFiles)));
    rebuild();
}

void RecentFiles::rebuild() {
    clear();
    for (const QString& path : QSettings().value(settingsKey).toStringList()) {
        if (!QFileInfo::exists(path)) continue;
        QAction* action = addAction(QFileInfo(path).fileName().replace('&', "&&"));
        action->setToolTip(QDir::toNativeSeparators(path));
        action->setIcon(pictureOf(path));
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT chosen(path); });
    }
    setToolTipsVisible(true);
    menuAction()->setEnabled(!isEmpty());
}

}  // namespace chiaro::app
