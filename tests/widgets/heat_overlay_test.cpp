#include "widgets/viewport/heat_overlay.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::HeatMap;
using widgets::HeatOverlay;

namespace {

/// 8 x 4 pixels: the left half is nothing, the right half 0.1, 0.2, .. from left to right.
std::shared_ptr<HeatMap> rightHalf() {
    auto map = std::make_shared<HeatMap>();
    map->title = "Similarity error";
    map->values = ScalarImage(8, 4, -1);
    map->best = Image<glm::i16vec2>(8, 4, glm::i16vec2(-1));
    map->objects = IdImage(8, 4, 0);
    map->most = 0.4F;
    for (int y = 0; y < 4; ++y)
        for (int x = 4; x < 8; ++x) {
            map->values(x, y) = 0.1F * float(x - 3);
            map->best(x, y) = {x, y};
            map->objects(x, y) = 1;
        }
    QImage strip(40, 10, QImage::Format_RGB32);
    strip.fill(Qt::darkGreen);
    map->strips = {{strip, QSize(80, 20)}};
    map->paint();
    return map;
}

class Ground : public QWidget {
public:
    int presses = 0, moves = 0;
    QPointF last;

protected:
    void mousePressEvent(QMouseEvent* event) override {
        ++presses;
        last = event->position();
    }
    void mouseMoveEvent(QMouseEvent* event) override {
        ++moves;
        last = event->position();
    }
};

struct Shown {
    Ground ground;
    HeatOverlay* overlay = new HeatOverlay(&ground);

    Shown() {
        ground.resize(800, 400);
        overlay->resize(800, 400);
        ground.show();
        (void)QTest::qWaitForWindowExposed(&ground);
    }
    QImage drawn() {
        QImage image(overlay->size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        overlay->render(&image, {}, {}, QWidget::RenderFlags());
        return image;
    }
};

}  // namespace

class HeatOverlayTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readingsAreThoseOfThePixelBelow() {
        Shown shown;
        QVERIFY(!shown.overlay->reading({500, 200}));
        shown.overlay->setMap(rightHalf());
        QVERIFY(!shown.overlay->reading({399, 200}));
        const auto first = shown.overlay->reading({401, 99});
        QVERIFY(first);
        QCOMPARE(first->value, 0.1F);
        QCOMPARE(int(first->object), 1);
        QVERIFY(first->best == glm::ivec2(4, 0));
        QCOMPARE(shown.overlay->reading({799, 399})->value, 0.4F);
        QVERIFY(!shown.overlay->reading({800, 399}));
        QVERIFY(!shown.overlay->reading({-1, 0}));
    }

    void theMapIsClearWhereNothingWasMeasured() {
        const auto map = rightHalf();
        QCOMPARE(qAlpha(map->picture.pixel(3, 0)), 0);
        QVERIFY(qAlpha(map->picture.pixel(4, 0)) > 200);
        QVERIFY2(qGray(map->picture.pixel(7, 0)) > qGray(map->picture.pixel(4, 0)) + 60,
                 "larger errors are brighter");
        Shown shown;
        shown.overlay->setMap(map);
        QCOMPARE(qAlpha(shown.drawn().pixel(100, 100)), 0);
        QVERIFY(qAlpha(shown.drawn().pixel(700, 100)) > 200);
    }

    void thePanelComesWithAMapOrWithWork() {
        Shown shown;
        const QPoint corner(shown.overlay->width() - 30, shown.overlay->height() - 20);
        QCOMPARE(qAlpha(shown.drawn().pixel(corner)), 0);
        shown.overlay->setProgress("measuring…", 0.5);
        QVERIFY(qAlpha(shown.drawn().pixel(corner)) > 100);
        shown.overlay->setProgress({}, std::nullopt);
        QCOMPARE(qAlpha(shown.drawn().pixel(corner)), 0);
    }

    void thePointerReadsAndGoesOnToTheViewport() {
        Shown shown;
        shown.overlay->setMap(rightHalf());
        const QImage before = shown.drawn();
        QTest::mouseMove(shown.overlay, QPoint(450, 150));
        const QImage after = shown.drawn();
        QVERIFY2(before.pixel(480, 180) != after.pixel(480, 180), "the value stands beside the pointer");
        QTest::mousePress(shown.overlay, Qt::LeftButton, {}, QPoint(100, 60));
        QCOMPARE(shown.ground.presses, 1);
        QCOMPARE(shown.ground.last, QPointF(100, 60));
        QTest::mouseMove(shown.overlay, QPoint(120, 70));
        QVERIFY2(shown.ground.moves > 0, "so a drag turns the view");
        QCOMPARE(shown.ground.last, QPointF(120, 70));
        QTest::mouseRelease(shown.overlay, Qt::LeftButton, {}, QPoint(120, 70));
    }
};

QTEST_MAIN(HeatOverlayTest)
#include "heat_overlay_test.moc"
