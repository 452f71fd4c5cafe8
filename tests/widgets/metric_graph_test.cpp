#include "widgets/metric_graph.h"

#include "widgets/folding_row.h"
#include "widgets/metric_axes.h"
#include "widgets/metric_legend.h"
#include "widgets/metric_row.h"
#include "widgets/round_step.h"

#include <QtTest>
#include <QtWidgets>

#include <set>

using namespace chiaro;
using widgets::MetricGraph;

namespace {

/// Two curves over frames 1..5; the second has no point at the first frame.
metrics::LineChart twoCurves() {
    metrics::LineChart chart;
    chart.title = "Similarity";
    chart.x = {"frame", std::nullopt, {}, false};
    chart.y = {"error", 0, {}, false};
    chart.series = {{"flat", {}}, {"rising", {}}};
    for (int frame = 1; frame <= 5; ++frame) {
        chart.series[0].points.push_back({double(frame), 0.25, 0});
        if (frame > 1) chart.series[1].points.push_back({double(frame), 0.1 * frame, 0.01});
    }
    return chart;
}

struct Shown {
    MetricGraph graph;
    QSignalSpy picked{&graph, &MetricGraph::pickedChanged};
    QSignalSpy clicked{&graph, &MetricGraph::clicked};

    Shown() {
        graph.setChart(twoCurves(), "Frame");
        graph.resize(400, 240);
        graph.show();
        (void)QTest::qWaitForWindowExposed(&graph);
        QTest::qWait(20);
    }
    QWidget* canvas() { return graph.findChild<QAbstractScrollArea*>()->viewport(); }
    /// Moves the pointer to a share of the graph's width.
    void point(double share) {
        const QPointF at(share * graph.width(), graph.height() / 2.0);
        QMouseEvent move(QEvent::MouseMove, at, canvas()->mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(canvas(), &move);
    }
};

}  // namespace

class MetricGraphTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void thePointerPicksTheNearestPoint() {
        Shown shown;
        double last = 0;
        std::set<double> met;
        for (double share = 0.2; share < 0.97; share += 0.02) {
            shown.point(share);
            QVERIFY(shown.graph.picked());
            QVERIFY2(*shown.graph.picked() >= last, "going right, what is picked goes right too");
            last = *shown.graph.picked();
            met.insert(last);
        }
        QVERIFY((met == std::set<double>{1, 2, 3, 4, 5}));
        QCOMPARE(shown.picked.count(), 5);
    }

    void hoveringNeedsNoButton() {
        Shown shown;
        QTest::mouseMove(shown.canvas(), QPoint(shown.graph.width() / 2, 60));
        QTRY_VERIFY_WITH_TIMEOUT(shown.graph.picked(), 3000);
    }

    void theNoteTellsEveryCurvesValue() {
        Shown shown;
        shown.graph.pick(3);
        QCOMPARE(shown.graph.note(), QString("Frame 3\nflat  0.25000\nrising  0.30000 ± 0.01000"));
        QCOMPARE(shown.graph.accessibleDescription(), shown.graph.note());
        shown.graph.pick(1);
        QCOMPARE(shown.graph.note(), QString("Frame 1\nflat  0.25000"));
        shown.graph.pick(std::nullopt);
        QVERIFY(shown.graph.note().isEmpty());
        QCOMPARE(shown.picked.count(), 0);  // it was told, it does not tell
    }

    void aClickTakesWhatIsPicked() {
        Shown shown;
        QTest::mouseClick(shown.canvas(), Qt::LeftButton, {},
                          QPoint(shown.graph.width() - 14, shown.graph.height() / 2));
        QCOMPARE(shown.clicked.count(), 1);
        QCOMPARE(shown.clicked[0][0].toDouble(), 5.0);
    }

    void keysGoFromPointToPoint() {
        Shown shown;
        shown.graph.setFocus();
        QTest::keyClick(&shown.graph, Qt::Key_Return);
        QCOMPARE(shown.clicked.count(), 0);
        for (int i = 0; i < 2; ++i) QTest::keyClick(&shown.graph, Qt::Key_Right);
        QCOMPARE(*shown.graph.picked(), 2.0);
        QTest::keyClick(&shown.graph, Qt::Key_Return);
        QCOMPARE(shown.clicked.count(), 1);
        for (int i = 0; i < 9; ++i) QTest::keyClick(&shown.graph, Qt::Key_Left);
        QCOMPARE(*shown.graph.picked(), 1.0);
        shown.graph.pick(std::nullopt);
        QTest::keyClick(&shown.graph, Qt::Key_Left);
        QCOMPARE(*shown.graph.picked(), 5.0);
    }

    void withoutPointsThereIsNothingToPick() {
        Shown shown;
        shown.graph.setChart({});
        shown.point(0.5);
        QVERIFY(!shown.graph.picked());
        QTest::keyClick(&shown.graph, Qt::Key_Right);
        QVERIFY(!shown.graph.picked());
    }

    void curvesAreDrawnInTheirColours() {
        Shown shown;
        const QImage picture = shown.graph.grab().toImage();
        for (const std::size_t series : {0u, 1u}) {
            const QColor wanted = MetricGraph::color(series);
            int count = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) {
                    const QColor color = picture.pixelColor(x, y);
                    count += std::abs(color.red() - wanted.red()) < 12 &&
                             std::abs(color.green() - wanted.green()) < 12 &&
                             std::abs(color.blue() - wanted.blue()) < 12;
                }
            QVERIFY2(count > 100, qPrintable(QString("%1 pixels").arg(count)));
        }
    }

    void aRowPicksTogetherAndSharesItsScale() {
        widgets::MetricRow row;
        metrics::LineChart tall = twoCurves();
        for (metrics::ChartPoint& point : tall.series[0].points) point.y = 4;
        row.setCharts({twoCurves(), tall}, true, "Frame");
        row.resize(700, 240);
        row.show();
        QVERIFY(QTest::qWaitForWindowExposed(&row));
        QCOMPARE(row.count(), 2);
        QTest::keyClick(row.graph(0), Qt::Key_Right);
        QCOMPARE(*row.graph(1)->picked(), 1.0);
        QSignalSpy clicked(&row, &widgets::MetricRow::clicked);
        QTest::keyClick(row.graph(0), Qt::Key_Return);
        QCOMPARE(clicked.count(), 1);
        row.setShown(0, false);
        QCOMPARE(row.shownCharts().size(), 1U);
        row.setCharts({twoCurves(), tall}, false);
        QVERIFY2(row.graph(0)->isHidden(), "new figures don't bring back what was put away");
        QCOMPARE(widgets::mostOf(tall), 4.0);
    }

    void aRowFoldsWhereItIsTooNarrow() {
        auto* left = new QLabel("a line of switches");
        auto* right = new widgets::MetricLegend;
        right->setNames({"Image-based", "View-aligned", "View-dependent"});
        widgets::FoldingRow row(left, right);
        const int wide = row.sizeHint().width();
        QVERIFY(row.heightForWidth(wide / 2) > row.heightForWidth(wide));
        row.resize(wide, row.heightForWidth(wide));
        row.show();
        QCOMPARE(right->geometry().right(), wide - 1);
        row.resize(wide / 2, row.heightForWidth(wide / 2));
        QVERIFY(right->y() >= left->geometry().bottom());
    }

    void stepsAreRound() {
        QCOMPARE(widgets::roundStep(0.38, 4), 0.1);
        QCOMPARE(widgets::roundStep(8, 4), 2.0);
        QCOMPARE(widgets::roundStep(7, 6), 2.0);
        QCOMPARE(widgets::roundStep(1000, 2), 500.0);
    }
};

QTEST_MAIN(MetricGraphTest)
#include "metric_graph_test.moc"
