#include "app/export_dialog.h"
#include "app/heat_maps.h"
#include "app/mesh_export_dialog.h"
#include "app/metric_tools.h"
#include "core/base/atomic_file.h"
#include "tests/app/app_support.h"
#include "tests/app/event_meter_support.h"
#include "tests/app/window_support.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

#include <numbers>

using namespace chiaro;
using app::MainWindow;
using test::MeteredApplication;

namespace {

constexpr double largestHold = 50;  ///< ms, what a hand on the mouse doesn't notice
constexpr int longestWait = 240'000;

/// A torus of so many rings and segments, 2 faces each, as a PLY file: where there is no large scan.
void writeTorus(const std::filesystem::path& path, int rings, int segments) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(rings * segments) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(2 * rings * segments) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    const auto angle = [](int i, int count) { return 2 * std::numbers::pi * i / count; };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < segments; ++s) {
            const double radius = 2 + std::cos(angle(s, segments));
            for (const double value : {radius * std::cos(angle(r, rings)), radius * std::sin(angle(r, rings)),
                                       std::sin(angle(s, segments))})
                text += std::to_string(value) + " ";
            text += "\n";
        }
    const auto index = [&](int r, int s) {
        return std::to_string(r % rings * segments + s % segments) + " ";
    };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < segments; ++s) {
            text += "3 " + index(r, s) + index(r + 1, s) + index(r + 1, s + 1) + "\n";
            text += "3 " + index(r, s) + index(r + 1, s + 1) + index(r, s + 1) + "\n";
        }
    writeFileAtomically(path, text);
}

/// Sends drags to the viewport at the pace of a hand.
void drag(widgets::Viewport& viewport, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const QPoint middle = viewport.rect().center();
    QTest::mousePress(&viewport, button, modifiers, middle);
    for (int i = 1; i <= 12; ++i) {
        const QPoint at = middle + QPoint(6 * i, 2 * i);
        QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&viewport, &move);
        QTest::qWait(10);
    }
    QTest::mouseRelease(&viewport, button, modifiers, middle + QPoint(72, 24));
}

/// Accepts the next dialog of a kind, with this in its file field.
template <class Dialog>
void acceptNext(const std::filesystem::path& file) {
    QTimer::singleShot(100, qApp, [file] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        for (QLineEdit* field : dialog->template findChildren<QLineEdit*>())
            if (field->accessibleName() == "File") field->setText(QString::fromStdString(file.string()));
        dialog->accept();
    });
}

}  // namespace

class ResponsivenessTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;
    std::unique_ptr<MainWindow> m_window;

    /// Says how long the window was held up since the last call, and whether that is short enough.
    bool isBrief(const char* phase) {
        MeteredApplication& meter = MeteredApplication::instance();
        const MeteredApplication::Hold longest = meter.longest();
        qInfo("%s: at most %.1f ms (%s); drawing %.1f ms", phase, longest.milliseconds,
              qPrintable(longest.what), meter.longestDrawing().milliseconds);
        meter.reset();
        return longest.milliseconds < largestHold;
    }
    bool settle() { return test::settle(*m_window, longestWait); }
    void useMethod(const std::string& key) {
        const QString name = "method-" + QString::fromStdString(key);
        QTest::mouseClick(m_window->findChild<QToolButton*>(name), Qt::LeftButton);
    }
    bool open(const std::vector<std::filesystem::path>& paths) {
        QStringList names;
        for (const auto& path : paths) names << QString::fromStdString(path.string());
        MeteredApplication::instance().measure("open()", [&] { m_window->open(names); });
        return settle() && !m_window->document().project().meshes.empty();
    }
    /// A strip and half a million faces, with settings that are quick to make.
    bool openLargeMesh() {
        project::Project project;
        project.levels.size = 128;
        project.levels.count = 4;
        project.views.count = 4;
        project.views.size = 128;
        m_window->document().replace(project, {}, {});
        std::filesystem::path mesh = test::sharedData() / "meshes/large_22_objects.ply";
        if (!std::filesystem::exists(mesh)) {
            mesh = m_folder / "torus.ply";
            writeTorus(mesh, 500, 500);
        }
        if (!open({test::writeStrip(m_folder / "strip.png", 320, 96), mesh})) return false;
        std::size_t faces = 0;
        const std::vector<widgets::ViewSnapshot> shown = m_window->viewport().snapshots();
        for (const scene::Object& object : shown.front().scene.objects)
            faces += object.mesh->triangles.size();
        qInfo("%zu faces", faces);
        return faces >= 490'000;
    }

private Q_SLOTS:
    void initTestCase() { test::prepareWindows(m_folder); }

    void aHoldIsNoticed() {
        MeteredApplication::instance().reset();
        QTimer::singleShot(0, this, [] {
            for (const double end = test::threadMilliseconds() + 60; test::threadMilliseconds() < end;) {
            }
        });
        QTest::qWait(10);
        QVERIFY(MeteredApplication::instance().longest().milliseconds >= 60);
        QVERIFY2(!isBrief("a loop of 60 ms"), "the meter sees nothing");
    }

    void nothingHoldsTheWindowUp_data() {
        QTest::addColumn<bool>("isLarge");
        QTest::newRow("demo") << false;
        QTest::newRow("half a million faces") << true;
    }

    void nothingHoldsTheWindowUp() {
        QFETCH(bool, isLarge);
        const std::string size = isLarge ? "large" : "small";
        m_window = std::make_unique<MainWindow>();
        const auto close = qScopeGuard([this] { m_window.reset(); });
        m_window->resize(1000, 640);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QTest::qWait(100);
        MeteredApplication::instance().reset();

        QVERIFY(isLarge ? openLargeMesh() : open({test::resource("demo/demo.chiaro")}));
        bool isAlwaysBrief = isBrief("loading and synthesis");
        widgets::Viewport& viewport = m_window->viewport();
        viewport.setFocus();
        for (const std::string method : {"view-aligned", "image-based", "view-dependent"}) {
            useMethod(method);
            QVERIFY(settle());
            QCOMPARE(m_window->document().project().method, method);
            isAlwaysBrief &= isBrief(method.c_str());
            drag(viewport, Qt::MiddleButton, Qt::NoModifier);
            drag(viewport, Qt::RightButton, Qt::ShiftModifier);
            QTest::keyClick(&viewport, Qt::Key_Home);
            QVERIFY(settle());
            isAlwaysBrief &= isBrief((method + ", dragging").c_str());
        }
        useMethod("view-aligned");
        QVERIFY(settle());
        m_window->metrics().heatMaps().similarityAction()->trigger();
        QVERIFY(
            QTest::qWaitFor([&] { return m_window->metrics().viewMeasures().isMapFinal(); }, longestWait));
        m_window->metrics().heatMaps().similarityAction()->trigger();
        QVERIFY(settle());
        isAlwaysBrief &= isBrief("figures and heat map");

        acceptNext<app::ExportDialog>(m_folder / (size + ".png"));
        test::menuAction(*m_window, "Export Picture…")->trigger();
        acceptNext<app::MeshExportDialog>(m_folder / (size + ".glb"));
        test::menuAction(*m_window, "Export Mesh…")->trigger();
        QVERIFY(settle());
        QVERIFY(std::filesystem::exists(m_folder / (size + ".png")));
        QVERIFY(std::filesystem::exists(m_folder / (size + ".glb")));
        isAlwaysBrief &= isBrief("export");
        m_window->document().undoStack().setClean();
        QVERIFY2(isAlwaysBrief, "something holds the window up for 50 ms or more: see above");
    }
};

CHIARO_METERED_MAIN(ResponsivenessTest)
#include "responsiveness_test.moc"
