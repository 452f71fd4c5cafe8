#include "tests/app/window_support.h"

#include <QtTest>
#include <QtWidgets>

/// Outside any namespace, as the macro demands.
static void registerResources() {
    Q_INIT_RESOURCE(resources);
}

namespace chiaro::test {

void prepareWindows(const TemporaryFolder& folder) {
    registerResources();
    QCoreApplication::setOrganizationName("ChiaroTests");
    QStandardPaths::setTestModeEnabled(true);
    qputenv("HOME", folder.path().c_str());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(folder.path().string()));
}

bool settle(app::MainWindow& window, int milliseconds) {
    return QTest::qWaitFor(
        [&] {
            const std::string& method = window.document().project().method;
            return window.jobs().isIdle() && (method != "image-based" || window.frameTextures().isFinal()) &&
                   (method != "view-dependent" || window.objectTextures().isFinal());
        },
        milliseconds);
}

bool openAndSettle(app::MainWindow& window, const std::vector<std::filesystem::path>& paths,
                   int milliseconds) {
    QStringList names;
    for (const auto& path : paths) names << QString::fromStdString(path.string());
    window.open(names);
    return settle(window, milliseconds);
}

QAction* menuAction(const QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text().remove('&') == text) return action;
    return nullptr;
}

}  // namespace chiaro::test
