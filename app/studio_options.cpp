#include "app/studio_options.h"

#include "app/language.h"

#include <QtCore>

#include <cstdio>
#include <cstdlib>

namespace chiaro::app {

namespace {

constexpr int wrongUsage = 2;
constexpr int leastSide = 200;  // px
constexpr int mostSide = 16384;

[[noreturn]] void refuse(const QString& sentence) {
    std::fprintf(stderr, "chiaro-studio: %s\n", qPrintable(sentence));
    std::exit(wrongUsage);
}

/// "1280x720".
QSize parseSize(const QString& text) {
    static const QRegularExpression form("^(\\d{1,5})x(\\d{1,5})$");
    const QRegularExpressionMatch match = form.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    const auto isGood = [](int side) { return side >= leastSide && side <= mostSide; };
    if (!match.hasMatch() || !isGood(size.width()) || !isGood(size.height()))
        refuse(QString("--size %1: is no size; would be right: WIDTHxHEIGHT in px, each %2 to %3")
                   .arg(text)
                   .arg(leastSide)
                   .arg(mostSide));
    return size;
}

}  // namespace

QStringList dockNames() {
    return {"sample",   "scene",        "parameters", "gradient", "view-planning",
            "timeline", "metric-graph", "jobs",       "history"};
}

StudioOptions parseStudioOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QString("Shades 3D meshes with an artist's own paint."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(
        "FILE", QString("Projects, strips and meshes to open; the demo without any."), "[FILE...]");
    const QCommandLineOption safe(
        "safe",
        QString(
            "Start with the usual layout, without OpenGL and without anything that was remembered: for when "
            "the studio does not start otherwise. Nothing is remembered from it either."));
    const QCommandLineOption theme("theme", QString("Light or dark, for this time: dark, light or system."),
                                   "NAME");
    const QCommandLineOption language(
        "language", QString("The studio's language, for this time: %1.").arg(languageCodes().join(", ")),
        "CODE");
    const QCommandLineOption size("size", QString("The size of the window, px."), "WxH");
    const QCommandLineOption screenshot(
        "screenshot", QString("Write a picture of the window once everything has settled, and quit."),
        "OUT.png");
    const QCommandLineOption dock(
        "dock", QString("The screenshot shows one dock alone: %1.").arg(dockNames().join(", ")), "NAME");
    const QCommandLineOption timeStart(
        "time-start", "Print how long it took until the window was painted and took input, and quit.");
    parser.addOptions({safe, theme, language, size, screenshot, dock, timeStart});
    if (!parser.parse(arguments)) refuse(parser.errorText());
    if (parser.isSet(version)) parser.showVersion();
    if (parser.isSet(help)) parser.showHelp();

    StudioOptions options;
    options.files = parser.positionalArguments();
    options.screenshot = parser.value(screenshot);
    options.dock = parser.value(dock);
    options.language = parser.value(language);
    options.timesStart = parser.isSet(timeStart);
    options.isSafe = parser.isSet(safe);
    if (parser.isSet(size)) options.size = parseSize(parser.value(size));
    if (parser.isSet(theme)) {
        options.theme = themeOfName(parser.value(theme));
        if (!options.theme)
            refuse(QString("--theme %1: is no theme; would be right: dark, light or system")
                       .arg(parser.value(theme)));
    }
    if (parser.isSet(language) && !languageCodes().contains(options.language))
        refuse(QString("--language %1: is not spoken here; would be right: %2")
                   .arg(options.language, languageCodes().join(", ")));
    if (parser.isSet(dock) && !dockNames().contains(options.dock))
        refuse(
            QString("--dock %1: is no dock; would be right: %2").arg(options.dock, dockNames().join(", ")));
    if (parser.isSet(dock) && !parser.isSet(screenshot))
        refuse(QString(
            "--dock: shows which dock a screenshot is of; would be right: with --screenshot OUT.png"));
    return options;
}

}  // namespace chiaro::app
