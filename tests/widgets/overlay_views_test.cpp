#include "widgets/viewport/overlay_views.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::OverlayViews;
using widgets::ViewMarks;

namespace {

/// A view of the unit cube around the origin.
views::View viewFrom(const glm::dvec3& direction) {
    views::View view;
    view.direction = direction;
    view.halfExtent = 1;
    return view;
}

/// The overlay over nothing, seen from +Z.
struct Shown {
    QWidget parent;
    OverlayViews* overlay = nullptr;

    Shown() {
        parent.resize(300, 200);
        overlay = new OverlayViews(&parent);
        scene::Camera camera;
        camera.azimuth = 0;
        camera.elevation = 0;
        camera.radius = 2;
        overlay->setCamera(camera);
        parent.show();
        (void)QTest::qWaitForWindowExposed(&parent);
    }
    QImage drawn(const ViewMarks& marks) {
        overlay->setMarks(marks);
        QImage image(overlay->size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        overlay->render(&image, {}, {}, QWidget::RenderFlags());
        return image;
    }
};

/// What of a part of a picture something is drawn on.
int drawnPixels(const QImage& image, const QRect& part) {
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x) count += qAlpha(image.pixel(x, y)) > 40 ? 1 : 0;
    return count;
}

}  // namespace

class OverlayViewsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itFollowsTheViewportAndLetsThePointerThrough() {
        Shown shown;
        shown.parent.resize(400, 240);
        QCOMPARE(shown.overlay->size(), QSize(400, 240));
        QVERIFY(shown.overlay->testAttribute(Qt::WA_TransparentForMouseEvents));
        QCOMPARE(drawnPixels(shown.drawn({}), shown.overlay->rect()), 0);
    }

    void aViewIsMarkedOnItsSideOfTheObject() {
        Shown shown;
        const QImage right = shown.drawn({.views = {{viewFrom({1, 0, 0})}}});
        QVERIFY(drawnPixels(right, {150, 0, 150, 200}) > 10);
        QCOMPARE(drawnPixels(right, {0, 0, 140, 200}), 0);
        // The object's own place in the world goes with it.
        const glm::mat4 turned(glm::vec4(-1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, -1, 0),
                               glm::vec4(0, 0, 0, 1));
        const QImage left = shown.drawn({.views = {{viewFrom({1, 0, 0})}}, .transform = turned});
        QVERIFY(drawnPixels(left, {0, 0, 150, 200}) > 10);
        QCOMPARE(drawnPixels(left, {160, 0, 140, 200}), 0);
    }

    void theSelectedViewShowsItsFrustum() {
        Shown shown;
        ViewMarks marks{.views = {{viewFrom({0, 0, 1})}}};
        const int before = drawnPixels(shown.drawn(marks), shown.overlay->rect());
        marks.selected = 0;
        QVERIFY(drawnPixels(shown.drawn(marks), shown.overlay->rect()) > before + 100);
    }

    void aPlacedViewIsFilled() {
        Shown shown;
        const auto alphaBesideTheNumber = [&](bool isPlaced) {
            views::View view = viewFrom({0, 0, 1});
            view.halfExtent = 3;  // so that there is room beside the number
            const QImage image = shown.drawn({.views = {{view, isPlaced}}});
            int least = 255;
            for (int y = 97; y < 103; ++y) least = std::min(least, qAlpha(image.pixel(168, y)));
            return least;
        };
        QCOMPARE(alphaBesideTheNumber(false), 0);
        QVERIFY(alphaBesideTheNumber(true) > 60);
    }

    void uncoveredFacesAreTintedAndThoseWithoutAreaDrawnAsLines() {
        Shown shown;
        const ViewMarks::Triangle face{glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(0, 1, 0)};
        const QImage tinted = shown.drawn({.laterFaces = {face}});
        QVERIFY(qAlpha(tinted.pixel(150, 100)) > 40);
        QVERIFY(qBlue(tinted.pixel(150, 100)) > qRed(tinted.pixel(150, 100)));
        const ViewMarks::Triangle line{glm::vec3(-1, 0, 0), glm::vec3(0, 0, 0), glm::vec3(1, 0, 0)};
        const QImage drawn = shown.drawn({.unreachableFaces = {line}});
        QVERIFY(drawnPixels(drawn, {100, 90, 100, 20}) > 20);
        QVERIFY(drawnPixels(drawn, shown.overlay->rect()) < 400);
    }

    void whatLiesBehindTheEyeIsLeftOut() {
        Shown shown;
        views::View view = viewFrom({0, 0, 1});
        view.target = {0, 0, 1000};
        QCOMPARE(drawnPixels(shown.drawn({.views = {{view}}, .selected = 0}), shown.overlay->rect()), 0);
    }
};

QTEST_MAIN(OverlayViewsTest)
#include "overlay_views_test.moc"
