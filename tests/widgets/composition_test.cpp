#include "widgets/viewport/composition.h"

#include <glm/common.hpp>

#include <QtTest>

namespace chiaro::widgets {

namespace {

using Mode = Composition::Mode;

const std::vector<std::string> threeMethods{"image-based", "view-aligned", "view-dependent"};

Composition composition(Mode mode, std::size_t count = 2) {
    Composition made;
    made.mode = mode;
    made.methods.assign(threeMethods.begin(), threeMethods.begin() + std::ptrdiff_t(count));
    return made;
}

QImage filled(QSize size, QColor color) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(color);
    return image;
}

constexpr QSize size(40, 20);

}  // namespace

class CompositionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oneMethodIsShownWhileNothingIsCompared() {
        QCOMPARE(Composition{}.shownCount(), 1U);
        QCOMPARE(composition(Mode::Single, 3).shownCount(), 1U);
        QCOMPARE(composition(Mode::Wipe, 1).shownCount(), 1U);
        QCOMPARE(composition(Mode::SideBySide, 3).shownCount(), 3U);
        QCOMPARE(composition(Mode::Blend, 3).shownCount(), 2U);
    }

    void panesAreEquallyLargeAndApart() {
        const auto three = paneRects(composition(Mode::SideBySide, 3), {604, 200});
        QCOMPARE(three,
                 (std::vector{QRect(0, 0, 200, 200), QRect(202, 0, 200, 200), QRect(404, 0, 200, 200)}));
        // What can't be divided stays empty at the end.
        const auto two = paneRects(composition(Mode::SideBySide), {101, 50});
        QCOMPARE(two, (std::vector{QRect(0, 0, 49, 50), QRect(51, 0, 49, 50)}));
        const auto column = paneRects(composition(Mode::SideBySide), {50, 102}, 2);
        QCOMPARE(column, (std::vector{QRect(0, 0, 50, 49), QRect(0, 53, 50, 49)}));
        QCOMPARE(paneRects(composition(Mode::Wipe), size), std::vector(2, QRect({}, size)));
    }

    void panesOfAWidgetFollowItsDevicePixels() {
        const auto panes = panesOf(composition(Mode::SideBySide), {101, 60}, 1.5);
        const QSize pixels = QSize(101, 60) * 1.5;
        QCOMPARE(panes[1].rect.right() * 1.5, double(pixels.width()) - (pixels.width() - 3) % 2);
        QCOMPARE(panes[0].seen, QPolygonF(panes[0].rect));
    }

    void aWipeShowsTheSecondBeyondItsLine() {
        Composition wipe = composition(Mode::Wipe);
        wipe.wipeCenter = {0.25, 0.5};
        const std::vector pictures{filled(size, Qt::red), filled(size, Qt::blue)};
        const auto isSecond = [&](int x, int y) {
            return composed(wipe, pictures, size, 1, Qt::black).pixelColor(x, y) == QColor(Qt::blue);
        };
        QVERIFY(!isSecond(9, 3) && isSecond(10, 3));
        wipe.wipeAngle = 180;
        QVERIFY(isSecond(9, 3) && !isSecond(10, 3));
        wipe.wipeAngle = 90;  // clockwise: the second comes to lie below
        QVERIFY(!isSecond(30, 9) && isSecond(30, 10));
        wipe.wipeCenter = {0.5, 0.5};
        wipe.wipeAngle = 45;
        QVERIFY(!isSecond(20, 8) && isSecond(22, 10) && !isSecond(11, 18) && isSecond(29, 2));
    }

    void whatIsSeenOfAWipeIsWhatIsDrawn() {
        Composition wipe = composition(Mode::Wipe);
        wipe.wipeCenter = {0.3, 0.6};
        wipe.wipeAngle = -67;
        const WipeLine line = wipeLine(wipe, size);
        const auto panes = panesOf(wipe, size, 1);
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x) {
                const bool second = line.isSecond({x + 0.5, y + 0.5});
                QCOMPARE(panes[1].seen.containsPoint({x + 0.5, y + 0.5}, Qt::OddEvenFill), second);
                QCOMPARE(panes[0].seen.containsPoint({x + 0.5, y + 0.5}, Qt::OddEvenFill), !second);
            }
    }

    void aWipesPositionGoesFromEdgeToEdge() {
        Composition wipe = composition(Mode::Wipe);
        for (const double angle : {0.0, 30.0, -90.0, 135.0, 180.0}) {
            wipe.wipeAngle = angle;
            wipe.wipeCenter = {0.5, 0.5};
            QVERIFY(std::abs(wipePosition(wipe, size) - 0.5) < 1e-9);
            for (const double position : {0.0, 0.2, 0.9, 1.0}) {
                const Composition moved = wipedTo(wipe, size, position);
                QVERIFY2(std::abs(wipePosition(moved, size) - position) < 1e-9,
                         qPrintable(QString::number(angle)));
                QCOMPARE(moved.wipeAngle, angle);
                QVERIFY(glm::clamp(moved.wipeCenter, 0.0, 1.0) == moved.wipeCenter);
            }
            const std::vector pictures{filled(size, Qt::red), filled(size, Qt::blue)};
            QCOMPARE(composed(wipedTo(wipe, size, 0), pictures, size, 1, Qt::black), pictures[1]);
            QCOMPARE(composed(wipedTo(wipe, size, 1), pictures, size, 1, Qt::black), pictures[0]);
        }
    }

    void aBlendWeighsTheSecond() {
        Composition blend = composition(Mode::Blend);
        const std::vector pictures{filled(size, QColor(100, 0, 255)), filled(size, QColor(200, 10, 0))};
        const auto at = [&](double share) {
            blend.blend = share;
            return composed(blend, pictures, size, 1, Qt::black).pixelColor(5, 5);
        };
        QCOMPARE(at(0), QColor(100, 0, 255));
        QCOMPARE(at(1), QColor(200, 10, 0));
        QCOMPARE(at(0.25), QColor(125, 3, 191));
    }

    void aDifferenceIsBlackWhereThePicturesAgree() {
        Composition difference = composition(Mode::Difference);
        const std::vector pictures{filled(size, QColor(100, 50, 30)), filled(size, QColor(90, 50, 130))};
        const auto with = [&](double gain) {
            difference.gain = gain;
            return composed(difference, pictures, size, 1, Qt::black).pixelColor(5, 5);
        };
        QCOMPARE(with(1), QColor(10, 0, 100));
        QCOMPARE(with(2), QColor(20, 0, 200));
        QCOMPARE(with(64), QColor(255, 0, 255));
    }

    void picturesSideBySideLieInTheirPanes() {
        const Composition apart = composition(Mode::SideBySide);
        const std::vector pictures{filled({19, 20}, Qt::red), filled({19, 20}, Qt::blue)};
        const QImage picture = composed(apart, pictures, size, 1, Qt::green);
        QCOMPARE(picture.size(), size);
        QCOMPARE(picture.pixelColor(18, 19), QColor(Qt::red));
        QCOMPARE(picture.pixelColor(19, 0), QColor(Qt::green));
        QCOMPARE(picture.pixelColor(20, 0), QColor(Qt::green));
        QCOMPARE(picture.pixelColor(21, 0), QColor(Qt::blue));
        QCOMPARE(picture.pixelColor(39, 10), QColor(Qt::blue));
    }
};

}  // namespace chiaro::widgets

QTEST_APPLESS_MAIN(chiaro::widgets::CompositionTest)
#include "composition_test.moc"
