#include "core/base/import.h"

#include "core/base/atomic_file.h"
#include "core/base/helper/helper_pool.h"
#include "tests/app/app_support.h"
#include "tests/fuzz/corpus.h"
#include "tests/fuzz/mutator.h"

#include <QtTest>

#include <fstream>

using namespace chiaro;
using test::Studio;

/// The studio while files are read in helpers, as it always runs.
class ImportTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    std::filesystem::path strip(const std::string& name) {
        std::filesystem::copy_file(test::resource("demo/samples/oil.png"), m_folder / name);
        return m_folder / name;
    }

    /// Processes of the hostile helper that this one has started.
    static int helperCount() {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
            std::ifstream file(entry.path() / "stat");
            std::string number, name, state;
            int parent = 0;
            if (file >> number >> name >> state >> parent)
                count += parent == ::getpid() && name == "(hostile_helper)";
        }
        return count;
    }

private Q_SLOTS:
    void cleanup() { importInHelpers({.program = CHIARO_HOSTILE_HELPER}); }

    void theStudioLoadsNoImageLibraryToRead() {
        importInHelpers({});
        Studio studio;
        QVERIFY(studio.open({test::resource("demo/demo.chiaro")}));
        QVERIFY2(studio.errors.empty(), studio.errors.empty() ? "" : qPrintable(studio.errors.front()));
        QVERIFY(studio.paints.state(0).scan);
        QVERIFY(!studio.meshes.scene().objects.empty());
        QVERIFY(!importHelpers()->idleProcesses().empty());
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);)
            QVERIFY2(line.find("OpenImageIO") == line.npos && line.find("chiaro_codec") == line.npos,
                     line.c_str());
    }

    void aCrashIsASentenceAndChangesNothing() {
        Studio studio;
        const project::Project before = studio.document.project();
        QVERIFY(studio.open({strip("crash.png")}));
        QCOMPARE(studio.errors.size(), 1U);
        QCOMPARE(
            studio.errors.front(),
            QString::fromStdString((m_folder / "crash.png").string()) +
                ": can't be read: its reader crashed (Segmentation fault); the file may be damaged, so copy "
                "it or save it again");
        QVERIFY(studio.document.project() == before);
    }

    /// Whatever is dropped on the window.
    void spoiledFilesNeverStopTheStudio() {
        importInHelpers({.seconds = 10});
        for (const test::Format& format : test::formats()) {
            const test::Mutator mutator(format.corpus());
            Studio studio;
            for (std::size_t number = 0; number < test::rounds(4, 200); ++number) {
                const auto path = m_folder / (std::to_string(number) + format.extension);
                writeFileAtomically(path, mutator.mutation(2'000'000 + number));
                QVERIFY(studio.open({path}));
            }
            for (const QString& error : studio.errors)
                QVERIFY2(error.contains("; ") && !error.contains('\n'), qPrintable(error));
        }
    }

    void cancellingAnImportThatHangsEndsItsHelper() {
        Studio studio;
        studio.opener.open({QString::fromStdString(strip("hang.png").string())});
        QTRY_COMPARE(helperCount(), 1);
        QTest::qWait(100);
        QElapsedTimer clock;
        clock.start();
        studio.jobs.cancelAll();
        while (helperCount() > 0 && clock.elapsed() < 2000) QTest::qWait(5);
        QVERIFY2(clock.elapsed() < 200, qPrintable(QString::number(clock.elapsed())));
        QVERIFY(studio.settle());
        QVERIFY(studio.errors.empty());
    }
};

QTEST_GUILESS_MAIN(ImportTest)
#include "import_test.moc"
