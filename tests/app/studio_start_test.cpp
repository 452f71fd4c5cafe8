#include "tests/support/support.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

struct Run {
    int status = -1;
    QString output;
    QString errors;
    QStringList loaded;  ///< the shared libraries that the program opened
};

/// The studio as a process of its own, told by the dynamic loader what it opens. Nothing of the user's is
/// read.
Run studio(const QStringList& arguments, const test::TemporaryFolder& folder,
           const QString& display = "here") {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    const QString traces = QString::fromStdString((folder / "loaded").string());
    environment.insert("LD_DEBUG", "files");
    environment.insert("LD_DEBUG_OUTPUT", traces);
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString((folder / "config").string()));
    environment.insert("LANGUAGE", "en");
    if (display.isEmpty()) {
        environment.remove("DISPLAY");
        environment.remove("WAYLAND_DISPLAY");
    }
    process.setProcessEnvironment(environment);
    process.start(CHIARO_STUDIO, arguments);
    process.waitForFinished(120'000);
    Run run{process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError()),
            {}};
    const QFileInfo trace(traces + "." + QString::number(process.processId()));
    for (const QFileInfo& one : trace.dir().entryInfoList({"loaded.*"})) {
        QFile file(one.filePath());
        if (!file.open(QIODevice::ReadOnly)) continue;
        static const QRegularExpression name("file=([^ ]+) \\[0\\]");
        const QString text = QString::fromUtf8(file.readAll());
        for (auto match = name.globalMatch(text); match.hasNext();) run.loaded << match.next().captured(1);
        file.close();
        QFile::remove(one.filePath());
    }
    run.loaded.removeDuplicates();
    return run;
}

bool anyContains(const QStringList& names, const QString& part) {
    return std::ranges::any_of(names, [&](const QString& name) { return name.contains(part); });
}

}  // namespace

class StudioStartTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    QString path(const char* name) const { return QString::fromStdString((m_folder / name).string()); }
    QString emptyProject() const {
        QFile file(path("empty.chiaro"));
        if (file.open(QIODevice::WriteOnly)) file.write(R"({"chiaro": 1, "samples": [], "objects": []})");
        return file.fileName();
    }

private Q_SLOTS:
    void helpAndVersionNeedNoDisplay() {
        const Run help = studio({"--help"}, m_folder, {});
        QCOMPARE(help.status, 0);
        for (const char* option : {"--safe", "--theme", "--language", "--screenshot", "--dock", "--size"})
            QVERIFY2(help.output.contains(option), option);
        const Run version = studio({"--version"}, m_folder, {});
        QCOMPARE(version.status, 0);
        QCOMPARE(version.output.trimmed(), QString("Chiaro %1").arg(CHIARO_VERSION));
    }

    void whatMakesNoSenseIsRefusedInASentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        QTest::newRow("theme") << QStringList{"--theme", "pink"} << "dark, light or system";
        QTest::newRow("language") << QStringList{"--language", "xx"} << "en, de";
        QTest::newRow("size") << QStringList{"--size", "big"} << "WIDTHxHEIGHT";
        QTest::newRow("tiny") << QStringList{"--size", "10x10"} << "200 to 16384";
        QTest::newRow("dock") << QStringList{"--screenshot", "x.png", "--dock", "kitchen"} << "view-planning";
        QTest::newRow("dock alone") << QStringList{"--dock", "sample"} << "--screenshot";
        QTest::newRow("unknown") << QStringList{"--frobnicate"} << "frobnicate";
    }
    void whatMakesNoSenseIsRefusedInASentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        const Run run = studio(arguments, m_folder);
        QCOMPARE(run.status, 2);
        QVERIFY2(run.errors.contains(named), qPrintable(run.errors));
        QVERIFY(run.errors.startsWith("chiaro-studio: ") || run.errors.contains("\nchiaro-studio: "));
    }

    /// 260 libraries that nobody waits for: those of pictures and of video.
    void theStartLoadsNoPictureOrVideoLibrary() {
        const Run run = studio({"--time-start", emptyProject()}, m_folder);
        QCOMPARE(run.status, 0);
        QVERIFY2(run.output.contains(QRegularExpression("^start: \\d+ ms, \\d+ ms of CPU time")),
                 qPrintable(run.output));
        QVERIFY(anyContains(run.loaded, "libQt6Widgets"));  // so the loader was heard
        for (const char* heavy :
             {"OpenImageIO", "opencv_videoio", "libavcodec", "chiaro_codec", "chiaro_video"})
            QVERIFY2(!anyContains(run.loaded, heavy), heavy);
    }

    void aSafeStudioTouchesNoOpenGlDriverAndNothingRemembered() {
        // A layout and a theme that a safe start must not take.
        QDir().mkpath(path("config/Chiaro"));
        QFile settings(path("config/Chiaro/Chiaro.conf"));
        QVERIFY(settings.open(QIODevice::WriteOnly));
        settings.write("[General]\ntheme=light\nlanguage=de\n");
        settings.close();
        const Run safe = studio(
            {"--safe", "--screenshot", path("safe.png"), "--size", "900x600", emptyProject()}, m_folder);
        QCOMPARE(safe.status, 0);
        for (const char* driver : {"swrast", "libGLX_mesa", "iris_dri", "nvidia"})
            QVERIFY2(!anyContains(safe.loaded, driver), driver);
        const QImage picture(path("safe.png"));
        QCOMPARE(picture.size(), QSize(900, 600));
        QVERIFY(qGray(picture.pixel(450, 3)) < 80);  // the dark menu bar
    }

    void aScreenshotIsOfTheSizeThemeAndDockThatIsAskedFor() {
        const Run run = studio({"--screenshot", path("sample.png"), "--dock", "sample", "--theme", "light",
                                "--size", "1000x700", emptyProject()},
                               m_folder);
        QCOMPARE(run.status, 0);
        const QImage picture(path("sample.png"));
        QVERIFY(picture.width() > 200 && picture.width() < 600);
        QVERIFY(qGray(picture.pixel(3, 3)) > 160);
    }
};

QTEST_MAIN(StudioStartTest)
#include "studio_start_test.moc"
