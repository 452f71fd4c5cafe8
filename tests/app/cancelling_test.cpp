#include "app/animation_export.h"
#include "app/distortion_study.h"
#include "app/mesh_export.h"
#include "app/method_comparison.h"
#include "app/view_measures.h"
#include "core/base/random.h"
#include "core/project/pipeline.h"
#include "tests/app/app_support.h"

#include <QtTest>
#include <QtWidgets>

#include <ctime>
#include <set>
#include <thread>

using namespace chiaro;
using test::Studio;

namespace {

constexpr double longestCancel = 200;  ///< ms
constexpr int mayStart = 4;            ///< threads that pools keep and one run may not have needed

double processMilliseconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

int threadsOfProcess() {
    return int(QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot).size());
}

/// The demo's skull and its paint, and all that the studio does in the background.
struct Work {
    Studio studio;
    widgets::ViewState state;
    app::ViewMeasures measures{
        studio.jobs, studio.paints, [this] {
            return std::vector{widgets::ViewSnapshot::of(state, state.method(), {240, 180})};
        }};
    app::MethodComparison comparison{studio.document, studio.jobs, studio.meshes};
    app::DistortionStudy study{studio.jobs, studio.paints};
    scene::Camera camera;
    std::filesystem::path folder;  ///< where exports go

    explicit Work(const std::filesystem::path& exports) : folder(exports) {
        measures.setLive(false);
        project::Project project;
        project.levels.size = 256;
        project.views.count = 4;
        project.views.size = 128;
        studio.document.replace(project, {}, {});
        studio.open({test::resource("demo/samples/oil.png"), test::resource("demo/meshes/skull.glb")});
        camera = project::cameraFor(studio.document.project(), studio.meshes.scene());
        study.setSample(0, "oil");
    }
    bool isReady() const {
        return studio.errors.empty() && !studio.document.project().samples.empty() &&
               studio.paints.state(0).levelsAreFinal;
    }
    void useMethod(const std::string& key) {
        studio.document.editMethod(key);
        studio.document.finishEdit();
    }
    /// Other textures than ever before, whatever the method.
    void reseed(int number) {
        auto levels = studio.document.project().levels;
        levels.quilt.seed = std::uint64_t(100 + number);
        studio.document.editLevels(levels);
        auto imageBased = studio.document.project().imageBased;
        imageBased.quilt.seed = levels.quilt.seed;
        studio.document.editImageBased(imageBased);
        studio.document.finishEdit();
    }
    void replan(int number) {
        auto views = studio.document.project().views;
        views.epsilon = 0.05 + 1e-4 * (number + 1);
        studio.document.editViews(views);
        studio.document.finishEdit();
    }
    app::PictureSource source(const std::string& method) const {
        project::Project project = studio.document.project();
        project.method = method;
        return {project, studio.meshes.scene(), camera, {{nullptr, studio.paints.gradient(0)}}, {}};
    }
    template <class Export>
    void startExport(const Export& write) {
        studio.jobs.start(
            {"Exporting", {}, {}, {}}, [write](const Task& task) { return write(task), true; }, [](bool) {});
    }
};

/// A kind of background work: how to begin the n-th of it, none of which is remembered from before.
struct Kind {
    const char* name;
    const char* method;
    void (*begin)(Work& work, int number);
};

void beginMap(Work& work, int) {
    work.state.setScene(work.studio.meshes.scene());
    work.state.camera = work.camera;
    work.state.setPaint(0, {work.studio.paints.state(0).levels, work.studio.paints.gradient(0)});
    work.measures.setMap(app::ViewMeasures::Map::Similarity);
    work.measures.restart();
}

void beginComparison(Work& work, int) {
    app::ComparisonSettings settings;
    settings.frames = 2;
    settings.size = 96;
    settings.pixels = 30;
    work.comparison.start(settings);
}

void beginAnimation(Work& work, int) {
    project::Project project = work.studio.document.project();
    project.animation.path = scene::Path::turntable(24);
    project.animation.firstFrame = 1;
    project.animation.lastFrame = 4;
    app::AnimationSettings settings;
    settings.output = work.folder / "animation.mkv";
    settings.width = 320;
    settings.height = 240;
    work.startExport([project, scene = work.studio.meshes.scene(), settings](const Task& task) {
        app::exportAnimation(project, scene, settings, task);
    });
}

const Kind kinds[] = {
    {"levels", "view-aligned", [](Work& work, int number) { work.reseed(number); }},
    {"mesh", "view-aligned",
     [](Work& work, int) {
         const auto large = test::sharedData() / "meshes/large_22_objects.ply";
         const auto path =
             std::filesystem::exists(large) ? large : test::resource("demo/meshes/still_life.obj");
         work.studio.opener.open({QString::fromStdString(path.string())});
     }},
    {"texture of the view", "image-based",
     [](Work& work, int number) {
         work.reseed(number);
         work.studio.frameTextures.setView(work.camera, {1280, 900});
     }},
    {"views", "view-dependent", [](Work& work, int number) { work.replan(number); }},
    {"textures of objects", "view-dependent", [](Work& work, int number) { work.reseed(number); }},
    {"heat map", "view-aligned", beginMap},
    {"comparison", "view-aligned", beginComparison},
    {"study", "view-aligned",
     [](Work& work, int) {
         work.study.start({{8}, 20, 1});
     }},
    {"picture", "view-aligned",
     [](Work& work, int) {
         app::PictureSettings settings;
         settings.path = work.folder / "picture.png";
         settings.width = 960;
         settings.height = 540;
         work.startExport([source = work.source("image-based"), settings](const Task& task) {
             app::exportPicture(source, settings, task);
         });
     }},
    {"animation", "view-aligned", beginAnimation},
    {"painted mesh", "view-aligned",
     [](Work& work, int) {
         const app::MeshSettings settings{work.folder / "mesh.glb", {.atlas = 512}};
         work.startExport([source = work.source("view-dependent"), settings](const Task& task) {
             app::exportMesh(source, settings, task);
         });
     }},
};

}  // namespace

class CancellingTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;
    std::filesystem::path m_temporary = m_folder / "temporary";
    std::filesystem::path m_exports = m_folder / "exports";

    /// False when it does not begin, or is over before anyone could see it.
    static bool begin(Work& work, const Kind& kind, int number) {
        kind.begin(work, number);
        return QTest::qWaitFor([&] { return !work.studio.jobs.jobs().empty(); }, 5000);
    }

    /// Cancels all that runs. Until its threads noticed: ms of the clock, or of the processors if those are
    /// fewer, for the machine may have other work.
    static double cancelAll(app::JobRunner& jobs) {
        const double processor = processMilliseconds();
        QElapsedTimer clock;
        clock.start();
        while (!jobs.jobs().empty()) jobs.cancelAll();  // one may be followed by the next object's
        while (jobs.threadsAtWork() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (qEnvironmentVariableIsSet("CHIARO_TRACE"))
            qInfo("%.1f ms, of processors %.1f", double(clock.nsecsElapsed()) * 1e-6,
                  processMilliseconds() - processor);
        return std::min(double(clock.nsecsElapsed()) * 1e-6, processMilliseconds() - processor);
    }

private Q_SLOTS:
    void initTestCase() {
        std::filesystem::create_directories(m_temporary);
        std::filesystem::create_directories(m_exports);
        qputenv("TMPDIR", m_temporary.c_str());
    }

    void nothingIsLeftOfWhatIsCancelled_data() {
        QTest::addColumn<int>("kind");
        for (int kind = 0; kind < int(std::size(kinds)); ++kind) QTest::newRow(kinds[kind].name) << kind;
    }

    /// Long: 100 times each, with CHIARO_LONG_TESTS=1 in the environment.
    void nothingIsLeftOfWhatIsCancelled() {
        QFETCH(int, kind);
        const int count = qEnvironmentVariableIsSet("CHIARO_LONG_TESTS") ? 100 : 5;
        Work work(m_exports);
        QVERIFY(work.isReady());
        app::JobRunner& jobs = work.studio.jobs;
        work.useMethod(kinds[kind].method);
        QVERIFY(work.studio.settle());

        // Once in full: how long it takes, and which threads it needs.
        QVERIFY(begin(work, kinds[kind], 0));
        QElapsedTimer clock;
        clock.start();
        QVERIFY(QTest::qWaitFor([&] { return jobs.isIdle() && !work.measures.isWaiting(); }, 120'000));
        const auto duration = double(clock.elapsed());
        const int threads = threadsOfProcess();

        Random random(std::uint64_t(kind) + 1);
        const std::set<std::string> whole{"picture.png", "animation.mkv", "mesh.glb"};
        double longest = 0;
        int amid = 0;
        for (int number = 1; number <= count; ++number) {
            QVERIFY(begin(work, kinds[kind], number));
            QTest::qWait(int(duration * random.uniform()));
            if (!jobs.jobs().empty()) ++amid;
            longest = std::max(longest, cancelAll(jobs));
            for (const auto& file : test::filesIn(m_exports)) {
                // What was whole in time is no leftover.
                QVERIFY2(whole.contains(file.filename().string()), file.c_str());
                std::filesystem::remove(file);
            }
        }
        qInfo("%s: %d of %d cancelled amid %.0f ms, at most %.1f ms until all threads were free",
              kinds[kind].name, amid, count, duration, longest);
        QVERIFY2(longest < longestCancel, "cancelling takes too long");
        QVERIFY(amid > 0);
        QVERIFY(std::filesystem::is_empty(m_temporary));
        QVERIFY2(threadsOfProcess() <= threads + mayStart, "threads are left behind");
        QVERIFY(work.studio.errors.empty());
    }
};

QTEST_MAIN(CancellingTest)
#include "cancelling_test.moc"
