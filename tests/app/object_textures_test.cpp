#include "app/object_textures.h"

#include "app/picture_export.h"
#include "core/base/image_io.h"
#include "core/project/pipeline.h"
#include "tests/app/app_support.h"

#include <QtTest>

using namespace chiaro;
using app::ObjectTextures;
using test::Studio;

namespace {

/// A project whose method is view-dependent, its strip and mesh open. Maps are just large enough for coarse
/// ones to come first.
struct Painted : Studio {
    explicit Painted(const test::TemporaryFolder& folder, const std::string& method = "view-dependent") {
        document.editMethod(method);
        views::ViewParams params;
        params.count = 3;
        params.size = 256;
        document.editViews(params);
        document.finishEdit();
        isReady = open({test::writeStrip(folder / "strip.png"),
                        test::writeTetrahedron(folder / "mesh.obj", "tetrahedron")});
        isReady &= method != "view-dependent" || settleFine();
        isReady &= errors.empty();
    }
    bool settleFine() {
        return QTest::qWaitFor([this] { return jobs.isIdle() && objectTextures.isFinal(); }, 20'000);
    }
    void propagate(bool on) {
        methods::ViewDependentParams params = document.project().viewDependent;
        params.propagate = on;
        document.editViewDependent(params);
    }
    int fineCount() const { return objectTextures.synthesisCount() - objectTextures.coarseCount(); }
    ObjectTextures::Painted shown() const { return objectTextures.textures().at(0); }

    bool isReady = false;
};

int mapSizeOf(const ObjectTextures::Painted& painted) {
    return painted->planned->plan.groups.at(0).view.size;
}

}  // namespace

class ObjectTexturesTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void aCoarseTextureComesFirstThenTheFineOne() {
        Painted studio(m_folder, "view-aligned");
        QVERIFY(studio.isReady);
        QCOMPARE(studio.objectTextures.synthesisCount(), 0);
        QVERIFY(!studio.shown());
        std::vector<int> sizes;
        connect(&studio.objectTextures, &ObjectTextures::texturesChanged, this, [&] {
            if (studio.shown()) sizes.push_back(mapSizeOf(studio.shown()));
        });
        studio.document.editMethod("view-dependent");
        QVERIFY(studio.settleFine());
        QCOMPARE(sizes, (std::vector<int>{64, 256}));
        QCOMPARE(studio.objectTextures.synthesisCount(), 2);
    }

    void theFineTextureIsWhatCoreMakes() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const project::Project& project = studio.document.project();
        const auto made =
            project::paintObject(project, project::planObject(project, studio.meshes.scene(), 0),
                                 project::separatePaint(project.samples[0]));
        const auto shown = studio.shown();
        QCOMPARE(shown->textures.views.size(), made->textures.views.size());
        for (std::size_t i = 0; i < made->textures.views.size(); ++i)
            QVERIFY(shown->textures.views[i].levels == made->textures.views[i].levels);
    }

    void coloursLightsAndBlendingBeginNothing() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const int made = studio.objectTextures.synthesisCount();
        const auto shown = studio.shown();
        for (int i = 0; i < 20; ++i) {
            studio.document.editRecoloring(
                0, gradient::ColorPath{{{0, glm::vec3(0)}, {1 - float(i) / 100, {1, 0, 0}}}});
            studio.document.editLight(0, {1, float(i), 0.5F});
            methods::ViewDependentParams params;
            params.followCamera = i % 2 == 0;
            studio.document.editViewDependent(params);
            studio.document.setCamera({.azimuth = float(i)});
            QVERIFY2(studio.jobs.isIdle(), "a job was started");
        }
        studio.document.finishEdit();
        QTest::qWait(450);
        QCOMPARE(studio.objectTextures.synthesisCount(), made);
        QCOMPARE(studio.shown(), shown);
        QVERIFY(studio.objectTextures.isFinal());
    }

    void otherMethodsMakeNone() {
        Painted studio(m_folder, "view-aligned");
        QVERIFY(studio.isReady);
        studio.propagate(false);
        studio.document.finishEdit();
        QVERIFY(studio.settle());
        QCOMPARE(studio.objectTextures.synthesisCount(), 0);
        QCOMPARE(studio.viewPlans.planCount(), 0);
    }

    void switchingThereAndBackFindsTheTexture() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const auto shown = studio.shown();
        const int made = studio.objectTextures.synthesisCount();
        studio.document.editMethod("view-aligned");
        QVERIFY(studio.settle());
        studio.document.editMethod("view-dependent");
        QVERIFY(studio.objectTextures.isFinal());
        QVERIFY(studio.settle());
        QCOMPARE(studio.shown(), shown);
        QCOMPARE(studio.objectTextures.synthesisCount(), made);
    }

    void undoFindsTheTextureStillThere() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const auto before = studio.shown();
        studio.propagate(false);
        studio.document.finishEdit();
        QCOMPARE(studio.shown(), before);  // until there is another
        QVERIFY(!studio.objectTextures.isFinal());
        QVERIFY(studio.settleFine());
        QVERIFY(studio.shown() != before);
        const int made = studio.objectTextures.synthesisCount();
        studio.document.undoStack().undo();
        QCOMPARE(studio.shown(), before);
        QVERIFY(studio.settleFine());
        QCOMPARE(studio.objectTextures.synthesisCount(), made);
    }

    void staleTexturesAreDropped() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const int fine = studio.fineCount();
        std::set<int> counts;
        connect(&studio.objectTextures, &ObjectTextures::texturesChanged, this,
                [&] { counts.insert(int(studio.shown()->textures.views.at(0).levels.size())); });
        synthesis::LevelParams params = studio.document.project().levels;
        for (int count : {3, 5, 6, 7}) {
            params.count = count;
            studio.document.editLevels(params);
            QVERIFY(!studio.jobs.isIdle());
            QVERIFY(studio.jobs.jobs().size() == 1);
        }
        studio.document.finishEdit();
        QVERIFY(studio.settleFine());
        QCOMPARE(counts, std::set<int>{7});
        QCOMPARE(studio.fineCount(), fine + 1);
    }

    void aDragMakesFineTexturesWhenItRests() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const int fine = studio.fineCount();
        synthesis::LevelParams params = studio.document.project().levels;
        for (int block = 17; block < 33; ++block) {
            params.quilt.block = block;
            studio.document.editLevels(params);
            QTest::qWait(10);
        }
        QCOMPARE(studio.fineCount(), fine);
        studio.document.finishEdit();
        QVERIFY(studio.settleFine());
        QCOMPARE(studio.fineCount(), fine + 1);
    }

    void cancellingWaitsForTheArtist() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        studio.propagate(false);
        studio.document.finishEdit();
        QVERIFY(!studio.jobs.isIdle());
        studio.jobs.cancelAll();
        QVERIFY(studio.settle());
        QTest::qWait(450);
        QVERIFY(studio.jobs.isIdle());
        QVERIFY(!studio.objectTextures.isFinal());
        studio.objectTextures.retry();
        QVERIFY(studio.settleFine());
    }

    void hiddenObjectsNeedNone() {
        Painted studio(m_folder, "view-aligned");
        QVERIFY(studio.isReady);
        project::Project project = studio.document.project();
        project.method = "view-dependent";
        project.objects = {{.name = "tetrahedron", .visible = false}};
        studio.document.replace(project, {}, {{"tetrahedron"}});
        QVERIFY(studio.settle());
        QCOMPARE(studio.objectTextures.synthesisCount(), 0);
        QVERIFY(studio.objectTextures.isFinal());
    }

    void anExportTakesTheTexturesOrMakesThem() {
        Painted studio(m_folder);
        QVERIFY(studio.isReady);
        const project::Project& project = studio.document.project();
        app::PictureSource source{project, studio.meshes.scene(), {}, {}, {}};
        source.camera = project::cameraFor(project, source.scene);
        source.paints = {{nullptr, studio.paints.gradient(0)}};
        app::PictureSettings settings{.path = m_folder / "made.png", .width = 160, .height = 120};
        app::exportPicture(source, settings, {});
        source.objectTextures = studio.objectTextures.textures();
        settings.path = m_folder / "taken.png";
        app::exportPicture(source, settings, {});
        const auto made = readImage(m_folder / "made.png").values;
        QVERIFY(made == readImage(m_folder / "taken.png").values);
        // What `chiaro render` makes.
        const auto paint = project::separatePaint(project.samples[0]);
        const auto gbuffer = scene::castGBuffer(scene::RayScene(source.scene), source.scene.lights,
                                                source.camera, settings.width, settings.height);
        const auto worn = project::wornPaints(project, source.scene, {paint});
        writeImage(m_folder / "core.png", project::renderFrame(project, worn, gbuffer).frame.picture,
                   ImageMetadata{}, PixelDepth::Bits8);
        QVERIFY(made == readImage(m_folder / "core.png").values);
    }
};

QTEST_GUILESS_MAIN(ObjectTexturesTest)
#include "object_textures_test.moc"
