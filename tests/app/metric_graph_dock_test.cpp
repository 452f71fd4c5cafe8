#include "app/docks/metric_graph_dock.h"

#include "app/comparison_table.h"
#include "app/distortion_study.h"
#include "app/docks/comparison_pane.h"
#include "app/docks/study_pane.h"
#include "app/method_comparison.h"
#include "app/view_measures.h"
#include "core/base/atomic_file.h"
#include "core/project/pipeline.h"
#include "tests/app/app_support.h"
#include "widgets/metric_graph.h"
#include "widgets/metric_row.h"
#include "widgets/parameter_form.h"

#include <QAbstractItemModelTester>
#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using app::MetricGraphDock;
using test::Studio;

namespace {

/// The dock in a window of its own.
struct Graph {
    Studio studio;
    app::MethodComparison comparison{studio.document, studio.jobs, studio.meshes};
    app::DistortionStudy study{studio.jobs, studio.paints};
    widgets::ViewState state;
    app::ViewMeasures measures{
        studio.jobs, studio.paints,
        [this] { return std::vector{widgets::ViewSnapshot::of(state, state.method(), {64, 64})}; }};
    QMainWindow window;
    MetricGraphDock* dock = new MetricGraphDock(studio.jobs, comparison, study, measures);

    explicit Graph(const test::TemporaryFolder& folder) {
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        window.resize(1200, 400);
        window.show();
        views::ViewParams views;
        views.count = 4;
        views.size = 64;
        studio.document.editViews(views);
        studio.document.finishEdit();
        studio.open({test::writeStrip(folder / "strip.png"),
                     test::writeTetrahedron(folder / "mesh.obj", "tetrahedron")});
        study.setSample(0, "strip");
    }
    /// So small that a test can wait for it.
    static app::ComparisonSettings small() {
        app::ComparisonSettings settings;
        settings.movement = app::ComparisonSettings::Movement::Turntable;
        settings.frames = 3;
        settings.period = 24;
        settings.size = 72;
        settings.pixels = 20;
        return settings;
    }
    bool compare() {
        comparison.start(small());
        return studio.settle() && comparison.result();
    }
    QPushButton* button(const char* name) { return dock->findChild<QPushButton*>(name); }
    std::string exported(const std::filesystem::path& path) {
        dock->exportTo(QString::fromStdString(path.string()));
        return studio.settle() && std::filesystem::exists(path) ? readFile(path, 1 << 24) : std::string();
    }
};

}  // namespace

class MetricGraphDockTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void withoutAMeshThereIsNothingToCompare() {
        Studio studio;
        app::MethodComparison comparison(studio.document, studio.jobs, studio.meshes);
        QVERIFY(!comparison.canStart());
        comparison.start({});
        QVERIFY(studio.jobs.isIdle());
    }

    void settingsAreCheckedAndFormed() {
        Graph graph(m_folder);
        QCOMPARE(graph.dock->form()->values(),
                 app::ComparisonSettings::table().values(app::ComparisonSettings{}));
        app::ComparisonSettings wrong;
        wrong.frames = 1;
        QVERIFY_EXCEPTION_THROWN(graph.comparison.start(wrong), std::exception);
        QVERIFY(!graph.comparison.isRunning());
    }

    void theReportsFiguresStandAloneAtFirst() {
        app::ComparisonTable table;
        const QAbstractItemModelTester tester(&table);
        QCOMPARE(table.rowCount(), 5);
        QCOMPARE(table.columnCount(), 6);
        QCOMPARE(table.index(0, 0).data().toString(), QString("–"));
        QCOMPARE(table.index(0, 1).data().toString(), QString("0.07539"));
        QCOMPARE(table.index(3, 5).data().toString(), QString("0.00547"));
        QVERIFY(table.index(4, 1).data().toString().isEmpty());
        project::MethodMeasure aligned;
        aligned.method = "view-aligned";
        aligned.similarity = {0.25, 0.01, 100};
        project::MethodMeasure dependent;
        dependent.method = "view-dependent";
        dependent.similarity = {0.125, 0.01, 100};
        table.setMeasures({aligned, dependent});
        QCOMPARE(table.index(0, 2).data().toString(), QString("0.25000 ± 0.01000"));
        QVERIFY(!table.index(0, 2).data(Qt::FontRole).value<QFont>().bold());
        QVERIFY2(table.index(0, 4).data(Qt::FontRole).value<QFont>().bold(), "the smallest is marked");
        QCOMPARE(table.index(1, 2).data().toString(), QString("–"));
        QCOMPARE(table.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), QString("View-aligned"));
    }

    void aComparisonFillsTheCurvesAndTheTable() {
        Graph graph(m_folder);
        QVERIFY(graph.button("measure-methods")->isEnabled());
        QVERIFY(graph.compare());
        QCOMPARE(graph.comparison.result()->table.size(), 3U);
        widgets::MetricRow* row = graph.dock->comparisonPane()->row();
        QCOMPARE(row->count(), 4);
        QCOMPARE(row->graph(0)->chart().series.size(), 3U);
        QCOMPARE(row->graph(0)->chart().series[0].points.size(), 3U);
        QCOMPARE(row->graph(2)->chart().series[0].points.size(), 2U);  // from frame to frame
        QVERIFY(graph.dock->table()->model()->index(0, 0).data().toString() != QString("–"));
        QVERIFY(graph.comparison.result()->table[0].frames.empty());
    }

    void aClickedFrameIsWantedWithItsCamera() {
        Graph graph(m_folder);
        QVERIFY(graph.compare());
        QSignalSpy frame(graph.dock, &MetricGraphDock::frameWanted);
        scene::Camera camera;
        connect(graph.dock, &MetricGraphDock::cameraWanted, graph.dock,
                [&](const scene::Camera& wanted) { camera = wanted; });
        widgets::MetricGraph* similarity = graph.dock->comparisonPane()->row()->graph(0);
        for (int i = 0; i < 3; ++i) QTest::keyClick(similarity, Qt::Key_Right);
        QTest::keyClick(similarity, Qt::Key_Return);
        QCOMPARE(frame.count(), 1);
        QCOMPARE(frame[0][0].toInt(), 3);
        const scene::Camera start =
            project::cameraFor(graph.studio.document.project(), graph.studio.meshes.scene());
        const float turned = camera.azimuth - start.azimuth;
        QVERIFY2(std::abs(std::remainder(std::abs(turned) - 2 * 360.0F / 24, 360.0F)) < 0.01F,
                 "frame 3 is two of 24 parts of a turn on");
        QCOMPARE(camera.radius, start.radius);
    }

    void anEditEndsTheComparison() {
        Graph graph(m_folder);
        graph.comparison.start(Graph::small());
        QVERIFY(graph.comparison.isRunning());
        graph.studio.document.editMethod("image-based");
        QVERIFY2(graph.comparison.isRunning(), "all methods are compared, whichever is shown");
        graph.studio.document.editLight(0, {0, 1, 0});
        QVERIFY(!graph.comparison.isRunning());
        QVERIFY(graph.comparison.problem().contains("edited"));
        QVERIFY(graph.studio.settle());
        QVERIFY(!graph.comparison.result());
    }

    void aResultIsMarkedOnceItIsOutdated() {
        Graph graph(m_folder);
        QVERIFY(graph.compare());
        QVERIFY(!graph.comparison.isOutdated());
        graph.studio.document.editLight(0, {0, 1, 0});
        graph.studio.document.finishEdit();
        QVERIFY(graph.comparison.isOutdated());
        QVERIFY(graph.comparison.result());
    }

    void cancellingLeavesNothing() {
        Graph graph(m_folder);
        QPushButton* measure = graph.button("measure-methods");
        measure->click();
        QVERIFY(graph.comparison.isRunning());
        QCOMPARE(measure->text(), QString("Cancel"));
        QElapsedTimer timer;
        timer.start();
        measure->click();
        QVERIFY(!graph.comparison.isRunning());
        QVERIFY(timer.elapsed() < 200);
        QCOMPARE(measure->text(), QString("Measure"));
        QVERIFY(!graph.comparison.result());
        QVERIFY(graph.studio.settle());
        QVERIFY(graph.studio.errors.empty());
    }

    void figuresAreWrittenByTheirExtension() {
        Graph graph(m_folder);
        QVERIFY(graph.dock->sheet().csv.empty());
        QVERIFY(graph.compare());
        const std::string csv = graph.exported(m_folder / "frames.csv");
        QVERIFY(csv.starts_with("frame,measure,method,error,standard_error,pixels\n"));
        QVERIFY(csv.find("3,\"Temporal, object space\",view-dependent,") != std::string::npos);
        graph.dock->findChild<QToolButton*>("chart-1")->setChecked(false);
        const std::string svg = graph.exported(m_folder / "frames.svg");
        QVERIFY(svg.starts_with("<svg"));
        QVERIFY(svg.find("Similarity") != std::string::npos && svg.find("Image-based") != std::string::npos);
        QVERIFY2(svg.find("Shading") == std::string::npos, "a chart that was put away is not written");
        QVERIFY(!graph.exported(m_folder / "frames.png").empty());
        const QImage png(QString::fromStdString((m_folder / "frames.png").string()));
        QVERIFY(png.width() > 300 && png.height() > png.width());
        graph.dock->setTab(MetricGraphDock::Tab::Table);
        QVERIFY(graph.exported(m_folder / "table.csv").starts_with("measure,method,error"));
        QVERIFY(graph.exported(m_folder / "table.md").find("0.07539") != std::string::npos);
        QVERIFY(graph.studio.errors.empty());
        QVERIFY(graph.exported(m_folder / "table.svg").empty());
        QCOMPARE(graph.studio.errors.size(), 1U);
        QVERIFY2(graph.studio.errors[0].contains(".csv or .md"), qPrintable(graph.studio.errors[0]));
    }

    void distortionsAreStudiedWithTheArtistsStrip() {
        Graph graph(m_folder);
        metrics::StudyParams params;
        params.blocks = {4, 8};
        params.pixels = 10;
        graph.study.start(params);
        QVERIFY(graph.study.isRunning());
        QVERIFY(graph.studio.settle());
        QVERIFY2(graph.study.problem().isEmpty(), qPrintable(graph.study.problem()));
        widgets::MetricRow* row = graph.dock->studyPane()->row();
        QCOMPARE(row->count(), 2);
        const metrics::LineChart& rotation = row->graph(0)->chart();
        QCOMPARE(rotation.series.size(), 4U);
        QVERIFY(rotation.series[3].name == "strip");
        QCOMPARE(rotation.series[0].points.front().y, 0.0);  // not turned
        QVERIFY(rotation.series[0].points.back().y > 0);
        graph.dock->setTab(MetricGraphDock::Tab::Distortions);
        QVERIFY(graph.exported(m_folder / "study.csv").starts_with("texture,distortion,block,"));
        QVERIFY(graph.exported(m_folder / "study.svg").starts_with("<svg"));
        graph.study.setSample(-1, {});
        QVERIFY(graph.study.isOutdated());
    }

    void anotherStripEndsTheStudy() {
        Graph graph(m_folder);
        graph.study.start();
        QVERIFY(graph.study.isRunning());
        graph.study.setSample(-1, {});
        QVERIFY(!graph.study.isRunning());
        QVERIFY(!graph.study.problem().isEmpty());
        graph.study.start();
        graph.study.cancel();
        QVERIFY(!graph.study.isRunning());
        QVERIFY(graph.study.problem().isEmpty());
        QVERIFY(graph.studio.settle());
        QVERIFY(graph.study.points().empty());
    }
};

QTEST_MAIN(MetricGraphDockTest)
#include "metric_graph_dock_test.moc"
