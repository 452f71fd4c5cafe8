#include "app/main_window.h"
#include "app/screenshot.h"
#include "app/theme.h"
#include "core/base/memory_reserve.h"
#include "core/base/resources.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

namespace {

/// What the studio opens when it is started without files.
QStringList demoProject() {
    try {
        const auto path = chiaro::resourceFolder() / "demo" / "demo.chiaro";
        return {QString::fromStdString(path.string())};
    } catch (const std::exception&) {
        return {};  // a studio without its demo still works
    }
}

}  // namespace

int main(int argc, char** argv) {
    chiaro::keepMemoryReserve();
    // Floating a dock makes a new OpenGL context, which finds the textures of the old one.
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("Chiaro");
    QCoreApplication::setApplicationName("Chiaro");
    QCoreApplication::setApplicationVersion(CHIARO_VERSION);
    Q_INIT_RESOURCE(resources);
    chiaro::app::applyTheme(application);

    QCommandLineParser parser;
    parser.setApplicationDescription("Shades 3D meshes with an artist's own paint.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("FILE", "Projects, strips and meshes to open; the demo without any.",
                                 "[FILE...]");
    const QCommandLineOption screenshot(
        "screenshot", "Write a picture of the window once everything has settled, and quit.", "OUT.png");
    parser.addOption(screenshot);
    parser.process(application);

    chiaro::app::MainWindow window;
    if (!parser.isSet(screenshot)) window.restoreLayout();
    window.show();
    const QStringList files = parser.positionalArguments();
    if (parser.isSet(screenshot)) new chiaro::app::Screenshot(window, parser.value(screenshot));
    const bool isAttended = !parser.isSet(screenshot);
    const bool isRecovering = isAttended && window.keepWorkSafe();
    if (!isRecovering || !files.isEmpty()) window.open(files.isEmpty() ? demoProject() : files);
    return QApplication::exec();
}
