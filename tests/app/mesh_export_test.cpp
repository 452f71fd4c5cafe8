#include "app/mesh_export.h"

#include "app/main_window.h"
#include "app/mesh_export_dialog.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "tests/app/app_support.h"
#include "widgets/message_bar.h"
#include "widgets/parameter_form.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

template <class Widget>
Widget* child(QWidget& parent, const QString& accessibleName) {
    for (Widget* widget : parent.findChildren<Widget*>())
        if (widget->accessibleName() == accessibleName) return widget;
    return nullptr;
}

QPushButton* button(QWidget& parent, const QString& text) {
    for (QPushButton* one : parent.findChildren<QPushButton*>())
        if (one->text().remove('&') == text) return one;
    return nullptr;
}

QAction* menuAction(QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text().remove('&') == text) return action;
    return nullptr;
}

}  // namespace

class MeshExportTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    app::PictureSource sourceOf(test::Studio& studio, const std::string& method) {
        test::writeStrip(m_folder / "strip.png");
        test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron");
        if (!studio.open({m_folder / "strip.png", m_folder / "mesh.obj"})) return {};
        project::Project project = studio.document.project();
        project.method = method;
        project.views.size = 64;
        project.views.count = 4;
        app::PictureSource source{project, studio.meshes.scene(), {}, {}, {}};
        source.paints = {{nullptr, studio.paints.gradient(0)}};
        return source;
    }

private Q_SLOTS:
    void writesWhatTheCommandLineWrites_data() {
        QTest::addColumn<QString>("method");
        for (const char* method : {"image-based", "view-aligned", "view-dependent"})
            QTest::newRow(method) << method;
    }

    void writesWhatTheCommandLineWrites() {
        QFETCH(QString, method);
        test::Studio studio;
        const app::PictureSource source = sourceOf(studio, method.toStdString());
        QCOMPARE(source.scene.objects.size(), 1u);
        const app::MeshSettings settings{m_folder / "made.glb", {.atlas = 128}};
        const exporting::AtlasReport report = app::exportMesh(source, settings, {});
        QCOMPARE(report.faces, 4u);
        const std::vector<project::Paint> paints{project::preparePaint(source.project, 0)};
        const project::ExportedMesh mesh = project::paintMesh(
            source.project, source.scene, project::wornPaints(source.project, source.scene, paints),
            exporting::MeshFormat::Glb, settings.params);
        exporting::writeTexturedScene(m_folder / "core.glb", mesh.scene,
                                      {{"Software", "Chiaro " CHIARO_VERSION}});
        QVERIFY(readFile(m_folder / "made.glb", 1 << 24) == readFile(m_folder / "core.glb", 1 << 24));
    }

    void objectsWithoutASampleAreGrey() {
        test::Studio studio;
        app::PictureSource source = sourceOf(studio, "view-aligned");
        source.project.samples.clear();
        source.paints.clear();
        app::exportMesh(source, {m_folder / "grey.ply", {}}, {});
        QCOMPARE(scene::readModel(m_folder / "grey.ply").faces, 4u);
    }

    void theDialogFollowsTheFile() {
        app::MeshExportDialog dialog({m_folder / "head.glb", {}}, nullptr);
        auto* path = child<QLineEdit>(dialog, "File");
        auto* format = dialog.findChild<QComboBox*>();
        QVERIFY(path && format);
        QCOMPARE(format->currentIndex(), 0);
        Q_EMIT format->activated(1);
        QVERIFY(path->text().endsWith("/head.obj"));
        QCOMPARE(format->currentIndex(), 1);
        path->setText(path->text().replace("head.obj", "head.v2"));
        QVERIFY(!button(dialog, "Export")->isEnabled());
        Q_EMIT format->activated(2);
        QVERIFY(path->text().endsWith("/head.v2.ply"));
        QVERIFY(button(dialog, "Export")->isEnabled());
        // What only concerns the texture can't be set for a file that has none.
        for (auto* form : dialog.findChildren<widgets::ParameterForm*>())
            QCOMPARE(form->isEnabled(), form->values().size() == 1);
    }

    void theDialogGivesTheParameters() {
        app::MeshExportDialog dialog({m_folder / "head.glb", {.atlas = 1024}}, nullptr);
        QCOMPARE(dialog.settings().params.atlas, 1024);
        for (auto* form : dialog.findChildren<widgets::ParameterForm*>()) {
            if (form->values().size() == 1) Q_EMIT form->valueEdited(0, 1);
            if (form->values().size() > 1) Q_EMIT form->valueEdited(1, 4);
        }
        QCOMPARE(dialog.settings().params,
                 (project::MeshExportParams{.atlas = 1024, .padding = 4, .bake = exporting::Bake::Texture}));
    }

    void theDialogAsksBeforeItReplaces() {
        writeFileAtomically(m_folder / "there.mtl", "mine");
        app::MeshExportDialog dialog({m_folder / "there.obj", {}}, nullptr);
        QVERIFY(test::asksBeforeItReplaces(dialog));
    }

    void theMenuWritesAMesh() {
        const auto strip = test::writeStrip(m_folder / "strip.png");
        const auto mesh = test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron");
        app::MainWindow window;
        window.show();
        window.open({QString::fromStdString(strip.string()), QString::fromStdString(mesh.string())});
        QVERIFY(QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 60'000));
        const auto file = m_folder / "menu.glb";
        QTimer::singleShot(100, &window, [&] {
            auto* dialog = qobject_cast<app::MeshExportDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            child<QLineEdit>(*dialog, "File")->setText(QString::fromStdString(file.string()));
            dialog->accept();
        });
        menuAction(window, "Export Mesh…")->trigger();
        QVERIFY(
            QTest::qWaitFor([&] { return std::filesystem::exists(file) && window.jobs().isIdle(); }, 60'000));
        QCOMPARE(scene::readModel(file).meshes.at(0).name, std::string("tetrahedron"));
        QVERIFY(window.messages().isVisible());
    }
};

QTEST_MAIN(MeshExportTest)
#include "mesh_export_test.moc"
