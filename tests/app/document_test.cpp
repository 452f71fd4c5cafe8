#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/app/app_support.h"

#include <QtTest>

#include <set>

using namespace chiaro;
using app::Change;
using app::Document;

namespace {

project::Project twoSamples() {
    project::Project project;
    project.samples.resize(2);
    project.samples[0].name = "oil";
    project.samples[1].name = "chalk";
    project.meshes = {{"/meshes/head.obj"}};
    project.objects.resize(2);
    project.objects[0].name = "skull";
    project.objects[1].name = "jaw";
    project.objects[1].sample = 1;
    return project;
}

const project::ObjectNames objectNames{{"skull", "jaw"}};

gradient::ColorPath pathTo(glm::vec3 color) {
    return {{{0, glm::vec3(0)}, {1, color}}, gradient::ColorPath::Space::Rgb};
}

synthesis::LevelParams levels(int count) {
    synthesis::LevelParams params;
    params.count = count;
    return params;
}

}  // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatAnswersAChangeIsNoEdit() {
        Document document;
        const project::Project before = document.project();
        // As a field does that loses the focus, half filled in, because of a change.
        connect(&document, &Document::changed, &document, [&] { document.editLight(0, {1, 2, 3}); });
        std::vector<scene::Light> lights = before.lights;
        lights.resize(2);
        document.editLights(lights, "Add Light");
        QCOMPARE(document.project().lights, lights);
        QCOMPARE(document.undoStack().count(), 1);
        document.undoStack().undo();
        QCOMPARE(document.project(), before);
        document.editMethod("image-based");
        QCOMPARE(document.undoStack().count(), 1);
        document.undoStack().setIndex(0);
        QCOMPARE(document.project(), before);
    }

    void aDragIsOneStep() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        QSignalSpy changed(&document, &Document::changed);
        for (int i = 1; i <= 10; ++i) document.editRecoloring(0, pathTo(glm::vec3(float(i) / 10)));
        document.finishEdit();
        QCOMPARE(changed.count(), 10);
        QCOMPARE(document.undoStack().count(), 1);
        document.editRecoloring(0, pathTo(glm::vec3(0.5F)));
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QCOMPARE(document.project().samples[0].recoloring, std::optional(pathTo(glm::vec3(1))));
        document.undoStack().undo();
        QVERIFY(!document.project().samples[0].recoloring.has_value());
    }

    void theMethodIsAnEditThatIsSaved() {
        const test::TemporaryFolder folder;
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        const std::string before = document.project().method;
        QSignalSpy changed(&document, &Document::changed);
        document.editMethod("image-based");
        document.finishEdit();
        methods::ImageBasedParams params;
        params.window = 7;
        document.editImageBased(params);
        document.finishEdit();
        methods::CoherenceParams coherence;
        coherence.every = 12;
        document.editCoherence(coherence);
        document.finishEdit();
        QCOMPARE(changed.count(), 3);
        QCOMPARE(changed[0][0].value<app::Change>().kind, app::Change::Kind::Method);
        document.save(folder / "study.chiaro");
        const project::Project saved = project::readProject(folder / "study.chiaro");
        QCOMPARE(saved.method, std::string("image-based"));
        QCOMPARE(saved.imageBased, params);
        QCOMPARE(saved.coherence, coherence);
        while (document.undoStack().canUndo()) document.undoStack().undo();
        QCOMPARE(document.project().method, before);
        QCOMPARE(document.project(), twoSamples());
    }

    void aPresetIsOneStep() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        const project::Project before = document.project();
        project::Project other;
        other.method = "view-dependent";
        other.levels.count = 5;
        other.views.count = 9;
        other.imageBased.window = 9;  // of another method: it stays as it is
        const auto preset = project::MethodPreset::of(other);
        document.applyPreset(preset);
        QCOMPARE(document.project().levels.count, 5);
        QCOMPARE(document.project().views.count, 9);
        QCOMPARE(document.project().imageBased, before.imageBased);
        QCOMPARE(document.undoStack().count(), 1);
        document.applyPreset(preset);
        QCOMPARE(document.undoStack().count(), 1);
        document.applyPreset(1, project::ViewPlanPreset{other.views, {{{0, 0, 1}, {0, 1, 0}}}});
        QCOMPARE(document.undoStack().count(), 2);
        QCOMPARE(document.placedViews(1).size(), 1U);
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.project(), before);
    }

    void aProjectOfANewerFormatIsNeverReplaced() {
        const test::TemporaryFolder folder;
        writeFileAtomically(folder / "a.chiaro", R"({"chiaro": 99, "samples": [], "brushes": 7})");
        Document document;
        document.replace(twoSamples(), folder / "a.chiaro", objectNames);
        document.setReadOnly();
        QVERIFY_EXCEPTION_THROWN(document.save(folder / "a.chiaro"), Error);
        QCOMPARE(readFile(folder / "a.chiaro", 1000), R"({"chiaro": 99, "samples": [], "brushes": 7})");
        QVERIFY(document.isReadOnly());
        document.save(folder / "a copy.chiaro");
        QVERIFY(!document.isReadOnly());
        QCOMPARE(document.path(), folder / "a copy.chiaro");
        document.save(folder / "a copy.chiaro");
    }

    void samplesAreEditedApart() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.editRecoloring(0, pathTo(glm::vec3(1)));
        document.editRecoloring(1, pathTo(glm::vec3(1)));
        QCOMPARE(document.undoStack().count(), 2);
    }

    void anEditThatChangesNothingIsNoStep() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.editStrip(0, document.project().samples[0].strip);
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
    }

    void aDragThatEndsWhereItBeganVanishes() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.editLevels(levels(9));  // so that the drag isn't merged into the clean state
        document.finishEdit();
        const auto before = document.project();
        sample::StripParams params = before.samples[0].strip;
        params.scale = 2;
        document.editStrip(0, params);
        document.editStrip(0, before.samples[0].strip);
        document.finishEdit();
        QCOMPARE(document.project(), before);
        QCOMPARE(document.undoStack().count(), 1);
    }

    void undoOfEverythingGivesBackTheProject() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        const auto before = document.project();
        sample::StripParams strip;
        strip.mirror = true;
        gradient::GradientParams gradient;
        gradient.searchScale = 3;
        document.editStrip(0, strip);
        document.editGradient(1, gradient);
        document.editRecoloring(1, pathTo({1, 0, 0}));
        document.editLevels(levels(16));
        document.editViewAligned({.density = 2});
        document.editLight(0, {1, 0, 0});
        document.addSample({}, 0);
        document.wearEverywhere(2);
        document.setMesh("/meshes/other.obj", {"whole"}, 1);
        document.removeSample(0);
        QCOMPARE(document.undoStack().count(), 10);
        const auto after = document.project();
        while (document.undoStack().canUndo()) document.undoStack().undo();
        QCOMPARE(test::withoutCamera(document.project()), before);
        QVERIFY(!document.isModified());
        while (document.undoStack().canRedo()) document.undoStack().redo();
        QCOMPARE(test::withoutCamera(document.project()), after);
    }

    void anyEditsOfTheSceneAreUndoneToTheLast() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Document document;
            document.replace(twoSamples(), {}, objectNames);
            const auto before = document.project();
            Random random(seed);
            const auto below = [&](std::size_t count) { return int(random.uniform() * double(count)); };
            for (int step = 0; step < 200; ++step) {
                auto objects = document.project().objects;
                auto lights = document.project().lights;
                const int object = objects.empty() ? -1 : below(objects.size());
                switch (object < 0 ? 0 : below(9)) {
                    case 0:
                        document.addMesh("/meshes/more.obj", {"skull", "hat"}, below(2));
                        break;
                    case 1:
                        document.removeObjects({object});
                        break;
                    case 2:
                        document.duplicateObjects({object});
                        break;
                    case 3:
                        objects[std::size_t(object)].name = random.uniform() < 0.5 ? "jaw" : "eye";
                        document.editObjects(objects, "rename");
                        break;
                    case 4:
                        objects[std::size_t(object)].placement.position.x = float(random.uniform());
                        document.editObjects(objects, "move");
                        break;
                    case 5:
                        lights.push_back({.vector = {float(random.uniform()), 1, 0}});
                        document.editLights(lights, "add");
                        break;
                    case 6:
                        if (!lights.empty()) lights.pop_back();
                        document.editLights(lights, "remove");
                        break;
                    case 7:
                        document.addView(object, {{1, 0, 0}, {0, 1, 0}});
                        break;
                    default:
                        if (document.undoStack().canUndo()) document.undoStack().undo();
                }
                if (random.uniform() < 0.7) document.finishEdit();
                // Whatever was done, it can be saved and read again.
                std::set<std::string> names;
                for (const auto& one : document.project().objects) {
                    QVERIFY(names.insert(one.name).second);
                    QVERIFY(one.mesh >= 0 && one.mesh < int(document.project().meshes.size()));
                    QVERIFY(one.sample >= 0 && one.sample < int(document.project().samples.size()));
                }
            }
            QVERIFY(document.project() != before);
            while (document.undoStack().canUndo()) document.undoStack().undo();
            QCOMPARE(document.project(), before);
        }
    }

    void aNewSampleIsWornInsteadOfTheSelectedOne() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        QCOMPARE(document.addSample({}, 0), 2);
        QCOMPARE(document.project().objects[0].sample, 2);
        QCOMPARE(document.project().objects[1].sample, 1);
        QVERIFY(!document.isWorn(0));
        QVERIFY(document.isWorn(2));
    }

    void objectsThatTheProjectDoesNotNameFollowToo() {
        Document document;
        project::Project project = twoSamples();
        project.objects.clear();
        document.replace(project, {}, objectNames);
        QCOMPARE(document.project().objects.size(), 2U);
        QVERIFY(!document.isModified());
        QVERIFY(document.isWorn(0));
        document.addSample({}, 0);
        QVERIFY(!document.isWorn(0));
        document.undoStack().undo();
        QVERIFY(document.isWorn(0));
    }

    void removingASampleRedressesItsObjects() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.removeSample(0);
        QCOMPARE(document.project().samples.size(), 1U);
        QCOMPARE(document.project().objects[0].sample, 0);
        QCOMPARE(document.project().objects[1].sample, 0);
    }

    void undoingAMeshBringsItsObjectsBack() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.setMesh("/meshes/other.obj", {"whole"}, 0);
        QVERIFY(!document.isWorn(1));
        document.undoStack().undo();
        QVERIFY(document.isWorn(1));
        QCOMPARE(document.project().meshes, std::vector<project::MeshFile>{{"/meshes/head.obj"}});
    }

    void lookingAroundIsNoEdit() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        scene::Camera camera;
        camera.azimuth = 77;
        document.setCamera(camera);
        QVERIFY(!document.isModified());
        QCOMPARE(document.project().camera.azimuth, 77.0F);
    }

    void savedAndReadAgainItIsTheSame() {
        const test::TemporaryFolder folder;
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.editRecoloring(0, pathTo({1, 0.5F, 0}));
        QVERIFY(document.isModified());
        document.save(folder / "study.chiaro");
        QVERIFY(!document.isModified());
        QCOMPARE(document.name(), "study");
        const project::Project read = project::readProject(folder / "study.chiaro");
        QCOMPARE(read.samples[0].recoloring, document.project().samples[0].recoloring);
    }

    void aRefusedSaveLeavesItModified() {
        Document document;
        document.replace(twoSamples(), {}, objectNames);
        document.editLevels(levels(5));
        QVERIFY_EXCEPTION_THROWN(document.save("/proc/nowhere/study.chiaro"), std::exception);
        QVERIFY(document.isModified());
        QVERIFY(document.path().empty());
    }
};

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
