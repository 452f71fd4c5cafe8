#include "app/autosave.h"
#include "core/base/atomic_file.h"
#include "core/project/backups.h"
#include "tests/app/app_support.h"
#include "tests/support/small_disk.h"

#include <QtTest>

using namespace chiaro;
using app::Autosave;
using app::Document;

namespace {

test::SmallDisk* disk = nullptr;  // as long as the program

/// Bytes that are left: none, less than a project takes, about as much, plenty.
constexpr std::array rooms{0, 4096, 8192, 12288, 16384, 24576, 40960, 65536, 131072, 1 << 20};
constexpr std::array sizes{1, 60, 250};

/// A project of so many samples, the last edit of it being number n.
void makeLarge(Document& document, int samples, int number) {
    project::Project project;
    for (int i = 0; i < samples; ++i)
        project.samples.push_back({.name = "paint number " + std::to_string(i),
                                   .scan = *disk / ("scan " + std::to_string(i) + ".png"),
                                   .strip = {},
                                   .gradient = {},
                                   .recoloring = {}});
    document.replace(project, {}, {});
    document.editLight(0, {float(number), 0, 1});
    document.finishEdit();
}

int numberIn(const std::filesystem::path& project) {
    return int(project::readProject(project).lights[0].vector.x);
}

std::set<std::string> namesOnDisk() {
    std::set<std::string> names;
    for (const auto& file : test::filesIn(disk->path())) names.insert(file.filename().string());
    return names;
}

}  // namespace

/// Nothing that the studio saves is lost to a full disk.
class FullDiskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cleanup() {
        disk->leaveAll();
        for (const auto& file : test::filesIn(disk->path())) std::filesystem::remove(file);
    }

    void theSavedProjectStaysOrIsReplacedWhole() {
        int failed = 0, saved = 0;
        for (const int size : sizes)
            for (const int room : rooms) {
                cleanup();
                const auto path = *disk / "study.chiaro";
                Document document;
                makeLarge(document, size, 1);
                document.save(path);
                document.editLight(0, {2, 0, 1});
                document.finishEdit();
                disk->leave(std::uint64_t(room));
                bool wasSaved = true;
                try {
                    document.save(path);
                } catch (const std::exception& error) {
                    wasSaved = false;
                    QVERIFY(QString(error.what()).contains("study.chiaro"));
                }
                disk->leaveAll();
                QCOMPARE(document.isModified(), !wasSaved);
                QCOMPARE(numberIn(path), wasSaved ? 2 : 1);
                const auto names = namesOnDisk();  // the project, and its backup as a second name
                QVERIFY(names.size() <= 2);
                for (const auto& backup : project::backupsOf(path)) QCOMPARE(numberIn(backup), 1);
                ++(wasSaved ? saved : failed);
            }
        QVERIFY(failed >= 3);
        QVERIFY(saved >= 3);
    }

    void theLastCopyThatFittedIsOffered() {
        int failed = 0, kept = 0;
        for (const int size : sizes)
            for (const int room : rooms) {
                cleanup();
                Document document;
                Autosave autosave(document, disk->path(), {.seconds = 1000, .edits = 1});
                QSignalSpy keptSpy(&autosave, &Autosave::kept), failedSpy(&autosave, &Autosave::failed);
                makeLarge(document, size, 1);
                QTRY_COMPARE(keptSpy.count(), 1);
                const auto before = namesOnDisk();
                disk->leave(std::uint64_t(room));
                document.editLight(0, {2, 0, 1});
                document.finishEdit();
                QTRY_COMPARE(keptSpy.count() + failedSpy.count(), 2);
                autosave.flush();
                disk->leaveAll();
                const bool wasKept = keptSpy.count() == 2;
                QVERIFY(namesOnDisk() == before);
                for (const auto& file : test::filesIn(disk->path()))
                    if (file.extension() == ".chiaro") QCOMPARE(numberIn(file), wasKept ? 2 : 1);
                ++(wasKept ? kept : failed);
            }
        QVERIFY(failed >= 3);
        QVERIFY(kept >= 3);
    }
};

int main(int argc, char** argv) {
    test::SmallDisk small;
    disk = &small;
    QCoreApplication application(argc, argv);
    FullDiskTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "full_disk_test.moc"
