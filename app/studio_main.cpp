#include "app/first_hints.h"
#include "app/forgotten_settings.h"
#include "app/helper_limits.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/screenshot.h"
#include "app/start_clock.h"
#include "app/studio_options.h"
#include "app/theme.h"
#include "core/base/memory_reserve.h"
#include "core/base/resources.h"
#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/viewport.h"

#include <QApplication>
#include <QLabel>
#include <QStatusBar>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>

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

bool isAmong(int argc, char** argv, std::initializer_list<std::string_view> wanted) {
    return std::any_of(argv + 1, argv + argc,
                       [&](const char* one) { return std::ranges::find(wanted, one) != wanted.end(); });
}

void saySafe(QMainWindow& window) {
    const QString text = QCoreApplication::translate("chiaro::app::SafeMode", "Safe mode");
    auto* label = new QLabel(text);
    label->setObjectName("safe-mode");
    label->setToolTip(QCoreApplication::translate(
        "chiaro::app::SafeMode",
        "Started with --safe: without OpenGL, in the usual layout, and nothing is remembered."));
    window.statusBar()->addPermanentWidget(label);
}

}  // namespace

int main(int argc, char** argv) {
    chiaro::keepMemoryReserve();
    QCoreApplication::setOrganizationName("Chiaro");
    QCoreApplication::setApplicationName("Chiaro");
    QCoreApplication::setApplicationVersion(CHIARO_VERSION);
    if (isAmong(argc, argv, {"--help", "-h", "--version", "-v"})) {
        const QCoreApplication withoutDisplay(argc, argv);
        chiaro::app::parseStudioOptions(QCoreApplication::arguments());
    }
    // Floating a dock makes a new OpenGL context, which finds the textures of the old one. It opens the
    // driver as soon as there is an application, before that has read any argument.
    if (!isAmong(argc, argv, {"--safe"})) QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    QGuiApplication::setDesktopFileName("io.github.chiaro.studio");
    Q_INIT_RESOURCE(resources);
    Q_INIT_RESOURCE(translations);

    using namespace chiaro::app;
    const StudioOptions options = parseStudioOptions(QCoreApplication::arguments());
    const bool isAttended = options.screenshot.isEmpty() && !options.timesStart;
    std::optional<ForgottenSettings> forgotten;
    if (options.isSafe || !isAttended) forgotten.emplace();
    if (options.isSafe) chiaro::widgets::forbidOpenGl();
    installLanguage(spokenLanguage(options.language.isEmpty() ? rememberedLanguage() : options.language));
    ThemeSwitch theme(options.theme.value_or(ThemeSwitch::remembered()));

    readFilesInHelpers();
    MainWindow window;
    window.addAppearance(theme);
    if (options.isSafe) saySafe(window);
    window.restoreLayout();
    if (options.size.isValid()) window.resize(options.size);
    window.show();
    if (!options.screenshot.isEmpty()) new Screenshot(window, options.screenshot, options.dock);
    if (options.timesStart) new StartClock(window);
    const bool isRecovering = isAttended && window.keepWorkSafe();
    if (isAttended && !isRecovering && !options.isSafe && options.files.isEmpty() && !FirstHints::wereSeen())
        new FirstHints(window.viewport());
    if (!isRecovering || !options.files.isEmpty())
        window.open(options.files.isEmpty() ? demoProject() : options.files);
    return QApplication::exec();
}
