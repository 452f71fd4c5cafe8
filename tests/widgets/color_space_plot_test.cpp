#include "widgets/color_space_plot.h"

#include "widgets/picture.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::ColorSpacePlot;

namespace {

/// How many pixels of the plot have about this colour.
int pixelsOf(ColorSpacePlot& plot, glm::vec3 color) {
    const QImage picture = plot.grab().toImage();
    const QColor wanted = widgets::toColor(color);
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            count += std::abs(pixel.red() - wanted.red()) + std::abs(pixel.green() - wanted.green()) +
                         std::abs(pixel.blue() - wanted.blue()) <
                     12;
        }
    return count;
}

struct Shown {
    ColorSpacePlot plot;

    Shown() {
        plot.resize(320, 220);
        plot.show();
        (void)QTest::qWaitForWindowExposed(&plot);
    }
};

double distance(QPointF a, QPointF b) {
    return QLineF(a, b).length();
}

}  // namespace

class ColorSpacePlotTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theCubeStandsInTheMiddleHoweverItIsTurned() {
        Shown shown;
        const QPointF middle(160, 110);
        const std::vector<std::pair<double, double>> turns{{0, 0}, {36, 22}, {-170, 90}, {500, -200}};
        for (const auto& [azimuth, elevation] : turns) {
            shown.plot.turn(azimuth, elevation);
            QVERIFY(distance(shown.plot.toWidget(glm::vec3(0.5F)), middle) < 1e-6);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 color(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
                QVERIFY(QRectF(shown.plot.rect()).contains(shown.plot.toWidget(color)));
            }
        }
        QCOMPARE(shown.plot.elevation(), -90.0);
        QCOMPARE(shown.plot.azimuth(), 140.0);
    }

    void seenFromTheFrontRedGoesRightAndGreenUp() {
        Shown shown;
        shown.plot.turn(0, 0);
        const QPointF black = shown.plot.toWidget({0, 0, 0});
        const double edge = 188 / std::sqrt(3.0);
        QVERIFY(distance(shown.plot.toWidget({1, 0, 0}), black + QPointF(edge, 0)) < 1e-3);
        QVERIFY(distance(shown.plot.toWidget({0, 1, 0}), black - QPointF(0, edge)) < 1e-3);
        QVERIFY(distance(shown.plot.toWidget({0, 0, 1}), black) < 1e-3);
        shown.plot.turn(0, 90);  // from above, what is near lies below
        QVERIFY(distance(shown.plot.toWidget({0, 0, 1}), shown.plot.toWidget({0, 0, 0}) + QPointF(0, edge)) <
                1e-3);
    }

    void whatIsHeldFollowsThePointer() {
        Shown shown;
        shown.plot.turn(0, 0);
        const QPointF near = shown.plot.toWidget({0.5F, 0.5F, 1});
        QTest::mousePress(&shown.plot, Qt::LeftButton, {}, {160, 110});
        QTest::mouseMove(&shown.plot, {200, 130});
        QTest::mouseRelease(&shown.plot, Qt::LeftButton, {}, {200, 130});
        const QPointF moved = shown.plot.toWidget({0.5F, 0.5F, 1}) - near;
        QVERIFY(moved.x() > 5 && moved.y() > 5);
        const double azimuth = shown.plot.azimuth();
        QTest::mouseMove(&shown.plot, {10, 10});
        QCOMPARE(shown.plot.azimuth(), azimuth);
        QTest::mouseDClick(&shown.plot, Qt::LeftButton, {}, {160, 110});
        QVERIFY(shown.plot.azimuth() != azimuth);
    }

    void keysTurnAsTheMouseDoes() {
        Shown shown;
        const double azimuth = shown.plot.azimuth(), elevation = shown.plot.elevation();
        QTest::keyClick(&shown.plot, Qt::Key_Right);
        QTest::keyClick(&shown.plot, Qt::Key_Down);
        QCOMPARE(shown.plot.azimuth(), azimuth - 5);
        QCOMPARE(shown.plot.elevation(), elevation + 5);
        QTest::keyClick(&shown.plot, Qt::Key_Left);
        QTest::keyClick(&shown.plot, Qt::Key_Up);
        QCOMPARE(shown.plot.azimuth(), azimuth);
        QTest::keyClick(&shown.plot, Qt::Key_Left);
        QTest::keyClick(&shown.plot, Qt::Key_Home);
        QCOMPARE(shown.plot.azimuth(), azimuth);
        QCOMPARE(shown.plot.elevation(), elevation);
    }

    void pointsLineAndPathAreDrawnInTheirColours() {
        Shown shown;
        const glm::vec3 point(0.9F, 0.1F, 0.5F), line(0.2F, 0.8F, 0.9F), path(0.95F, 0.75F, 0.1F);
        shown.plot.setColors({point}, {});
        QVERIFY(pixelsOf(shown.plot, point) >= 4);
        QCOMPARE(pixelsOf(shown.plot, line), 0);
        shown.plot.setColors({point}, {line - 0.01F, line + glm::vec3(-0.15F, 0, 0)});
        QVERIFY(pixelsOf(shown.plot, line - glm::vec3(0.08F, 0.005F, 0.005F)) >= 4);
        QCOMPARE(pixelsOf(shown.plot, path), 0);
        shown.plot.setPath({path, path + glm::vec3(-0.02F, 0.02F, 0.02F)}, {path});
        QVERIFY(pixelsOf(shown.plot, path) >= 20);
        shown.plot.setPath({}, {});
        QCOMPARE(pixelsOf(shown.plot, path), 0);
    }

    void anEmptyPlotAndALargeStripPaint() {
        Shown shown;
        QVERIFY(!shown.plot.grab().isNull());
        gradient::Gradient many;
        for (int i = 0; i < 8192; ++i) many.push_back(glm::vec3(float(i) / 8191));
        shown.plot.setColors(many, many);
        QVERIFY(!shown.plot.grab().isNull());
    }
};

QTEST_MAIN(ColorSpacePlotTest)
#include "color_space_plot_test.moc"
