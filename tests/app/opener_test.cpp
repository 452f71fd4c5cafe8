#include "app/file_kind.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "tests/app/app_support.h"

#include <QtTest>

using namespace chiaro;
using app::FileKind;
using test::Studio;

class OpenerTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    std::filesystem::path write(const std::string& name, std::string_view bytes) {
        writeFileAtomically(m_folder / name, bytes);
        return m_folder / name;
    }

private Q_SLOTS:
    void contentTellsTheKindBeforeTheName() {
        test::writeStrip(m_folder / "picture.png");
        std::filesystem::rename(m_folder / "picture.png", m_folder / "picture.obj");
        QCOMPARE(app::fileKind(m_folder / "picture.obj"), FileKind::Strip);
        QCOMPARE(app::fileKind(write("mesh.txt", "ply\nformat ascii 1.0\n")), FileKind::Mesh);
        QCOMPARE(app::fileKind(write("mesh.OBJ", "v 0 0 0\n")), FileKind::Mesh);
        QCOMPARE(app::fileKind(write("study.chiaro", "{}")), FileKind::Project);
        QVERIFY_EXCEPTION_THROWN(app::fileKind(write("notes.txt", "hello")), Error);
        QVERIFY_EXCEPTION_THROWN(app::fileKind(m_folder / "missing.png"), Error);
        QVERIFY_EXCEPTION_THROWN(app::fileKind(m_folder.path()), Error);
    }

    void aStripBecomesASampleAndAMeshWearsIt() {
        Studio studio;
        QVERIFY(studio.open(
            {test::writeStrip(m_folder / "oil.png"), test::writeTetrahedron(m_folder / "head.obj", "head")}));
        QVERIFY(studio.errors.empty());
        QCOMPARE(studio.document.project().samples.size(), 1U);
        QCOMPARE(studio.document.project().samples[0].name, std::string("oil"));
        QCOMPARE(studio.meshes.scene().objects.size(), 1U);
        QCOMPARE(studio.meshes.scene().objects[0].name, std::string("head"));
        QCOMPARE(studio.document.undoStack().count(), 2);
    }

    void brokenFilesSayWhyAndChangeNothing() {
        Studio studio;
        QVERIFY(studio.open(
            {test::writeStrip(m_folder / "oil.png"), test::writeTetrahedron(m_folder / "head.obj", "head")}));
        const project::Project before = studio.document.project();
        const auto objects = studio.meshes.scene().objects.size();
        const std::vector<std::filesystem::path> broken{write("broken.png", "\x89PNG\r\n\x1a\nnothing more"),
                                                        write("broken.obj", "f 1/1 2/2 99999999/3\n"),
                                                        write("broken.chiaro", "{ \"chiaro\": "),
                                                        write("empty.ply", ""), m_folder / "missing.tif"};
        QVERIFY(studio.open(broken));
        QCOMPARE(studio.errors.size(), broken.size());
        for (std::size_t i = 0; i < broken.size(); ++i) {
            const QString name = QString::fromStdString(broken[i].filename().string());
            QVERIFY2(studio.errors[i].contains(name), qPrintable(studio.errors[i]));
        }
        QCOMPARE(studio.document.project(), before);
        QCOMPARE(studio.meshes.scene().objects.size(), objects);
        QCOMPARE(studio.document.undoStack().count(), 2);
    }

    void aProjectWhoseStripIsMissingIsNotOpened() {
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "oil.png")}));
        const project::Project before = studio.document.project();
        project::Project other;
        other.samples.resize(1);
        other.samples[0].name = "gone";
        other.samples[0].scan = m_folder / "gone.png";
        project::writeProject(m_folder / "other.chiaro", other);
        QVERIFY(studio.open({m_folder / "other.chiaro"}));
        QCOMPARE(studio.errors.size(), 1U);
        QVERIFY(studio.errors[0].contains("gone.png"));
        QCOMPARE(studio.document.project(), before);
    }

    void aProjectComesBackAsItWasSaved() {
        Studio studio;
        QVERIFY(studio.open(
            {test::writeStrip(m_folder / "oil.png"), test::writeTetrahedron(m_folder / "head.obj", "head")}));
        studio.document.save(m_folder / "study.chiaro");
        const project::Project saved = studio.document.project();
        Studio fresh;
        QVERIFY(fresh.open({m_folder / "study.chiaro"}));
        QVERIFY(fresh.errors.empty());
        QCOMPARE(test::withoutCamera(fresh.document.project()), test::withoutCamera(saved));
        QCOMPARE(fresh.document.name(), "study");
        QVERIFY(!fresh.document.isModified());
        QVERIFY(fresh.paints.state(0).levelsAreFinal);
    }

    void theDemoIsOpenedAsACopy() {
        QVERIFY2(std::filesystem::exists(test::resource("demo/demo.chiaro")), "the demo is missing");
        Studio studio;
        QVERIFY(studio.open({test::resource("demo/demo.chiaro")}));
        QVERIFY(studio.errors.empty());
        QVERIFY(studio.document.path().empty());
        QVERIFY(!studio.meshes.scene().objects.empty());
    }

    void undoingAMeshBringsTheFormerBack() {
        Studio studio;
        QVERIFY(studio.open({test::writeTetrahedron(m_folder / "one.obj", "one"),
                             test::writeTetrahedron(m_folder / "two.obj", "two")}));
        QCOMPARE(studio.meshes.scene().objects[0].name, std::string("two"));
        studio.document.undoStack().undo();
        QVERIFY(studio.settle());
        QCOMPARE(studio.meshes.scene().objects[0].name, std::string("one"));
        studio.document.undoStack().undo();
        QVERIFY(studio.meshes.scene().objects.empty());
    }

    void aModifiedProjectIsReplacedOnlyWhenTheArtistSaysSo() {
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "oil.png")}));
        studio.document.save(m_folder / "study.chiaro");
        synthesis::LevelParams levels;
        levels.count = 5;
        studio.document.editLevels(levels);
        int asked = 0;
        studio.opener.setReplaceQuestion([&] { return ++asked, false; });
        QVERIFY(studio.open({m_folder / "study.chiaro"}));
        QCOMPARE(asked, 1);
        QCOMPARE(studio.document.project().levels.count, 5);
    }

    void aProjectOfANewerFormatIsOpenedReadOnly() {
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "oil.png")}));
        studio.document.save(m_folder / "new.chiaro");
        std::string text = readFile(m_folder / "new.chiaro", 1 << 20);
        text.replace(text.find("\"chiaro\": 2"), 11, "\"chiaro\": 3, \"brushes\": [1]");
        writeFileAtomically(m_folder / "new.chiaro", text);
        QStringList notes;
        connect(&studio.opener, &app::Opener::noted, this, [&](const QString& note) { notes << note; });
        QVERIFY(studio.open({m_folder / "new.chiaro"}));
        QVERIFY(studio.errors.empty());
        QVERIFY(studio.document.isReadOnly());
        QCOMPARE(studio.document.project().samples.size(), 1U);
        QCOMPARE(notes.size(), 1);
        QVERIFY2(notes[0].contains("new.chiaro") && notes[0].contains("format 3"), qPrintable(notes[0]));
        QVERIFY(studio.open({test::writeTetrahedron(m_folder / "head.obj", "head")}));
        QVERIFY(studio.document.isReadOnly());
        studio.document.undoStack().setClean();
        studio.document.save(m_folder / "mine.chiaro");
        QVERIFY(studio.open({m_folder / "mine.chiaro"}));
        QVERIFY(!studio.document.isReadOnly());
        QCOMPARE(readFile(m_folder / "new.chiaro", 1 << 20), text);
    }

    void whatIsEditedWhileAProjectLoadsIsAskedAbout() {
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "oil.png")}));
        studio.document.save(m_folder / "study.chiaro");
        int asked = 0;
        bool mayReplace = false;
        studio.opener.setReplaceQuestion([&] { return ++asked, mayReplace; });
        synthesis::LevelParams levels = studio.document.project().levels;
        const auto editWhileLoading = [&](int count) {
            studio.opener.open({QString::fromStdString((m_folder / "study.chiaro").string())});
            levels.count = count;
            studio.document.editLevels(levels);
            studio.document.finishEdit();
            return studio.settle();
        };
        QVERIFY(editWhileLoading(7));
        QCOMPARE(asked, 1);
        QCOMPARE(studio.document.project().levels.count, 7);
        QVERIFY(studio.document.isModified());
        // Asked before it loads and once more for what came since; changes that the artist let go of once
        // are not asked about again.
        mayReplace = true;
        QVERIFY(editWhileLoading(6));
        QCOMPARE(asked, 3);
        QCOMPARE(studio.document.project().levels.count, 4);
        levels.count = 7;
        studio.document.editLevels(levels);
        QVERIFY(studio.open({m_folder / "study.chiaro"}));
        QCOMPARE(asked, 4);
        QVERIFY(!studio.document.isModified());
    }

    void theBrokenFilesOfTheRealData() {
        if (!test::haveSharedData()) QSKIP("no real data beside the project");
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "oil.png")}));
        const auto samples = studio.document.project().samples.size();
        for (const char* kind : {"images", "meshes"})
            for (const auto& path : test::filesIn(test::sharedData() / "broken" / kind)) {
                const std::size_t errors = studio.errors.size();
                QVERIFY(studio.open({path}));
                const bool refused = studio.errors.size() > errors;
                const bool used = studio.document.undoStack().count() > 1;
                QVERIFY2(refused || used, path.filename().c_str());
                while (studio.document.undoStack().count() > 1 && studio.document.undoStack().canUndo() &&
                       studio.document.undoStack().index() > 1)
                    studio.document.undoStack().undo();
                QCOMPARE(studio.document.project().samples.size(), samples);
            }
    }
};

QTEST_GUILESS_MAIN(OpenerTest)
#include "opener_test.moc"
