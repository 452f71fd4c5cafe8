// soak SECONDS: what an artist does in a day, over and over: opens a project, edits and undoes, changes the
// method, exports pictures and meshes, saves. What the process holds must not grow: after a third of the
// time, in which caches fill, its heap by less than 1 MB an hour (less than 1 MB in all when it runs for less
// than ten minutes, too short to tell), its file descriptors and threads by none. Prints the slopes.

#include "app/mesh_export.h"
#include "app/picture_export.h"
#include "core/project/project.h"
#include "tests/app/app_support.h"
#include "tests/soak/usage.h"

#include <QtTest>

#include <cstdio>

namespace {

namespace fs = std::filesystem;
using namespace chiaro;

constexpr std::array methods{"view-aligned", "image-based", "view-dependent"};
constexpr double megabyte = 1 << 20;

class Artist {
public:
    Artist() {
        test::writeStrip(m_folder / "strip.png");
        test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron");
        test::Studio studio;
        if (!studio.open({m_folder / "strip.png", m_folder / "mesh.obj"})) fail("does not open");
        views::ViewParams views;
        views.size = 64;
        views.count = 4;
        studio.document.editViews(views);
        studio.document.save(m_folder / "study.chiaro");
        startAllThreads();
    }

    /// One round of work; the same each time.
    void work() {
        if (!m_studio.open({m_folder / "study.chiaro"})) fail("does not open again");
        app::Document& document = m_studio.document;
        for (const char* method : methods) {
            document.editMethod(method);
            document.editLight(0, {0.3f, 1, 0.5f});
            sample::StripParams strip;
            strip.mirror = true;
            document.editStrip(0, strip);
            document.finishEdit();
            settle();
            exportBoth(method);
            while (document.undoStack().canUndo()) document.undoStack().undo();
            while (document.undoStack().canRedo()) document.undoStack().redo();
            settle();
        }
        document.save(m_folder / "saved.chiaro");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

private:
    [[noreturn]] static void fail(const char* what) {
        std::fprintf(stderr, "soak: %s\n", what);
        std::exit(1);
    }

    /// Threads for jobs are started when one is wanted and none is free, which may happen first after hours.
    void startAllThreads() {
        app::JobSpec spec;
        spec.title = "Waiting";
        const auto wait = [](const Task&) {
            QThread::msleep(300);
            return true;
        };
        for (int i = 0; i < std::max(4, QThread::idealThreadCount()); ++i)
            m_studio.jobs.start(spec, wait, [](bool) {});
        settle();
    }

    void settle() {
        if (!m_studio.settle()) fail("does not settle");
        for (const QString& error : m_studio.errors) fail(error.toUtf8());
    }

    void exportBoth(const char* method) {
        app::PictureSource source{m_studio.document.project(), m_studio.meshes.scene(), {}, {}, {}};
        source.paints = {{nullptr, m_studio.paints.gradient(0)}};
        const std::string name = method;
        app::PictureSettings picture;
        picture.path = m_folder / (name + ".png");
        picture.width = picture.height = 96;
        app::exportPicture(source, picture, {});
        app::exportMesh(source, {m_folder / (name + ".glb"), {.atlas = 128}}, {});
    }

    test::TemporaryFolder m_folder;
    test::Studio m_studio;
};

template <class Figure>
bool isConstant(const std::vector<test::Usage>& usage, Figure test::Usage::*figure, const char* name) {
    const auto [least, most] = std::ranges::minmax_element(usage, {}, figure);
    std::printf("%s: %d to %d\n", name, int(*least.*figure), int(*most.*figure));
    // Threads that wait for work may end; nothing may be more than it was at first.
    return *most.*figure <= usage.front().*figure;
}

/// What was measured after the caches had filled.
bool isSteady(const std::vector<test::Usage>& usage) {
    const double seconds = usage.back().seconds - usage.front().seconds;
    const double heap = test::slopeOf(usage, &test::Usage::heap) / megabyte;
    const double resident = test::slopeOf(usage, &test::Usage::resident) / megabyte;
    std::printf("%zu rounds in %.0f s after the first ones\n", usage.size(), seconds);
    std::printf("heap: %.2f MB, slope %.3f MB an hour\n", usage.back().heap / megabyte, heap * 3600);
    std::printf("resident: %.2f MB, slope %.3f MB an hour\n", usage.back().resident / megabyte,
                resident * 3600);
    bool isFine = isConstant(usage, &test::Usage::files, "file descriptors");
    isFine &= isConstant(usage, &test::Usage::threads, "threads");
    if (seconds > 400)
        isFine &= heap * 3600 < 1;
    else
        isFine &= heap * seconds < 1;
    return isFine;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const double seconds = argc > 1 ? std::atof(argv[1]) : 20;
    QElapsedTimer clock;
    clock.start();
    const auto elapsed = [&] { return double(clock.elapsed()) / 1000; };
    Artist artist;
    int warm = 0;
    while (elapsed() < seconds / 3 || warm < 3) {
        artist.work();
        ++warm;
    }
    std::vector<test::Usage> usage;
    usage.reserve(1 << 16);  // so that it is no part of what it measures
    while (elapsed() < seconds || usage.size() < 3) {
        artist.work();
        usage.push_back(test::Usage::now(elapsed()));
    }
    const bool isFine = isSteady(usage);
    std::puts(isFine ? "steady" : "GROWING");
    return isFine ? 0 : 1;
}
