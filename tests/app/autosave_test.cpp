#include "app/autosave.h"

#include "app/project_lock.h"
#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "tests/app/app_support.h"

#include <QtTest>

#include <cstdio>

using namespace chiaro;
using app::Autosave;
using app::Document;

namespace {

/// Edits number n puts n where it can be read again.
void edit(Document& document, int number) {
    document.editLight(0, {float(number), 0, 1});
    document.finishEdit();
}

int numberIn(const project::Project& project) {
    return int(project.lights[0].vector.x);
}

/// A studio whose artist edits without end, and says so; to be killed.
int editForever(const std::filesystem::path& folder) {
    Document document;
    Autosave autosave(document, folder, {});
    QTimer pace;
    int number = 0;
    QObject::connect(&pace, &QTimer::timeout, &document, [&] {
        autosave.flush();  // artists are slower than disks
        edit(document, ++number);
        QCoreApplication::sendPostedEvents();
        autosave.flush();
        std::printf("%d\n", number);
        std::fflush(stdout);
    });
    pace.start(1);
    return QCoreApplication::exec();
}

/// A studio that has the project open until it is killed.
int holdForever(const std::filesystem::path& project) {
    app::ProjectLock lock;
    lock.take(project);
    std::printf("held\n");
    std::fflush(stdout);
    return QCoreApplication::exec();
}

std::size_t filesIn(const std::filesystem::path& folder) {
    return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

class AutosaveTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_root;
    int m_folders = 0;

    std::filesystem::path newFolder() { return m_root / std::to_string(++m_folders); }

private Q_SLOTS:
    void theFirstEditIsKeptAtOnceAndSavingRemovesIt() {
        const auto folder = newFolder();
        Document document;
        Autosave autosave(document, folder, {});
        QSignalSpy kept(&autosave, &Autosave::kept), cleared(&autosave, &Autosave::cleared);
        const std::size_t before = filesIn(folder);  // the lock
        edit(document, 1);
        QTRY_COMPARE(kept.count(), 1);
        QCOMPARE(filesIn(folder), before + 2);
        document.save(m_root / "saved.chiaro");
        QCOMPARE(cleared.count(), 1);
        autosave.flush();
        QCOMPARE(filesIn(folder), before);
        QVERIFY(autosave.leftovers().empty());
    }

    void laterEditsAreKeptInTheirRhythm() {
        Document document;
        Autosave autosave(document, newFolder(), {.seconds = 0.4, .edits = 5});
        QSignalSpy kept(&autosave, &Autosave::kept);
        edit(document, 1);
        QTRY_COMPARE(kept.count(), 1);
        for (int i = 2; i <= 4; ++i) edit(document, i);
        QTest::qWait(50);
        QCOMPARE(kept.count(), 1);  // neither five edits nor the time
        for (int i = 5; i <= 6; ++i) edit(document, i);
        QTRY_COMPARE(kept.count(), 2);
        edit(document, 7);
        QTRY_COMPARE_WITH_TIMEOUT(kept.count(), 3, 2000);  // the time
    }

    void undoingEverythingRemovesTheCopy() {
        const auto folder = newFolder();
        Document document;
        Autosave autosave(document, folder, {});
        edit(document, 1);
        QTRY_COMPARE(filesIn(folder), 3U);
        document.undoStack().undo();
        QCoreApplication::processEvents();
        autosave.flush();
        QCOMPARE(filesIn(folder), 1U);
    }

    void lookingAroundKeepsNothing() {
        const auto folder = newFolder();
        Document document;
        Autosave autosave(document, folder, {.seconds = 0.01, .edits = 1});
        document.setCamera({});
        document.replace({}, {}, {});
        QTest::qWait(60);
        QCOMPARE(filesIn(folder), 1U);
    }

    void aDiskThatRefusesIsToldOf() {
        Document document;
        Autosave autosave(document, "/proc/nowhere", {});
        QSignalSpy failed(&autosave, &Autosave::failed);
        edit(document, 1);
        QTRY_COMPARE(failed.count(), 1);
    }

    void copiesOfStudiosThatRunAreNotOffered() {
        const auto folder = newFolder();
        Document one, two;
        Autosave first(one, folder, {}), second(two, folder, {});
        edit(one, 1);
        QCoreApplication::processEvents();
        first.flush();
        QVERIFY(second.leftovers().empty());
    }

    void aTornNoteOrProjectHarmsNobody() {
        const auto folder = newFolder();
        writeFileAtomically(folder / "a.chiaro", "{");
        writeFileAtomically(folder / "a.json", "{ \"original\"");
        Document document;
        Autosave autosave(document, folder, {});
        QCOMPARE(autosave.leftovers().size(), 1U);
        autosave.discard(autosave.leftovers()[0]);
        autosave.flush();
        QVERIFY(autosave.leftovers().empty());
    }

    /// Long: 50 times, with CHIARO_LONG_TESTS=1 in the environment.
    void killedAtAnyMomentRecoveryIsOfferedWithTheLastEdits() {
        Random random(3);
        const int kills = qEnvironmentVariableIsSet("CHIARO_LONG_TESTS") ? 50 : 6;
        int mostLost = 0;
        for (int kill = 0; kill < kills; ++kill) {
            const auto folder = newFolder();
            QProcess studio;
            studio.start(QCoreApplication::applicationFilePath(),
                         {"--edit", QString::fromStdString(folder.string())});
            QVERIFY(studio.waitForReadyRead(20'000));
            QTest::qSleep(int(random.uniform() * 300));
            studio.kill();  // SIGKILL
            QVERIFY(studio.waitForFinished());
            const QList<QByteArray> numbers = studio.readAllStandardOutput().trimmed().split('\n');
            const int last = numbers.last().toInt();
            QVERIFY(last >= 1);
            test::Studio next;
            Autosave autosave(next.document, folder, {});
            const auto leftovers = autosave.leftovers();
            QCOMPARE(leftovers.size(), 1U);
            next.opener.recover(leftovers[0].kept, leftovers[0].original);
            QVERIFY(next.settle());
            QVERIFY(next.document.isModified());
            const int lost = last - numberIn(next.document.project());
            mostLost = std::max(mostLost, lost);
            QVERIFY2(lost <= 25, qPrintable(QString("%1 edits of %2 lost").arg(lost).arg(last)));
            autosave.takeOver(leftovers[0]);
            autosave.flush();
            QVERIFY(autosave.leftovers().empty());
        }
        qInfo("%d kills, at most %d edits lost", kills, mostLost);
    }

    void aProjectThatIsOpenElsewhereIsToldOf() {
        const auto project = m_root / "open.chiaro";
        QVERIFY(!app::ProjectLock::holder(project));
        app::ProjectLock lock;
        lock.take(project);
        QVERIFY(!app::ProjectLock::holder(project));  // by this very studio
        lock.take({});
        QProcess other;
        other.start(QCoreApplication::applicationFilePath(),
                    {"--hold", QString::fromStdString(project.string())});
        QVERIFY(other.waitForReadyRead(20'000));
        const auto holder = app::ProjectLock::holder(project);
        QVERIFY(holder && holder->contains(QString::number(other.processId())));
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY(!app::ProjectLock::holder(project));  // the dead hold nothing
        QVERIFY(!std::filesystem::exists(m_root / ".open.chiaro.lock"));
        QVERIFY(!app::ProjectLock::holder("/proc/nowhere/a.chiaro"));
    }

    void missingFilesCanBeFoundOrLeftOut() {
        test::Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_root / "there/oil.png"),
                             test::writeTetrahedron(m_root / "there/head.obj", "head")}));
        studio.document.save(m_root / "study.chiaro");
        std::filesystem::rename(m_root / "there", m_root / "elsewhere");
        test::Studio other;
        std::size_t missing = 0;
        other.opener.setMissingQuestion([&](project::Project& project) {
            missing = project::missingFiles(project).size();
            return true;
        });
        QVERIFY(other.open({m_root / "study.chiaro"}));
        QCOMPARE(missing, 2U);
        QCOMPARE(other.document.project().objects.size(), 1U);
        QVERIFY(!other.meshes.scene().objects[0].mesh);
        other.document.editMethod("view-dependent");  // nothing minds an object without a mesh
        other.viewPlans.setWanted(this, true);
        QVERIFY(other.settle());
        other.opener.setMissingQuestion([&](project::Project& project) {
            project::relink(project, project::missingFiles(project)[0], m_root / "elsewhere/oil.png");
            return true;
        });
        QVERIFY(other.open({m_root / "study.chiaro"}));
        QVERIFY(project::missingFiles(other.document.project()).empty());
        QVERIFY(other.meshes.scene().objects[0].mesh);
        QVERIFY(other.document.isModified());
        other.opener.setMissingQuestion([](project::Project&) { return false; });
        const project::Project before = other.document.project();
        QVERIFY(other.open({m_root / "study.chiaro"}));
        QCOMPARE(other.document.project(), before);
    }
};

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 3 && std::string_view(argv[1]) == "--edit") return editForever(argv[2]);
    if (argc == 3 && std::string_view(argv[1]) == "--hold") return holdForever(argv[2]);
    AutosaveTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "autosave_test.moc"
