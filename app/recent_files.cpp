#include "app/recent_files.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int maximumFiles = 10;
constexpr const char* settingsKey = "recentFiles";

}  // namespace

RecentFiles::RecentFiles(QWidget* parent) : QMenu(tr("Open &Recent"), parent) {
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
        QAction* action = addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT chosen(path); });
    }
    setToolTipsVisible(true);
    menuAction()->setEnabled(!isEmpty());
}

}  // namespace chiaro::app
