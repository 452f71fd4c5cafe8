#include "tests/widgets/viewport_support.h"
#include "widgets/viewport/picking.h"
#include "widgets/viewport/screen_bounds.h"

#include <QtTest>

namespace chiaro::widgets {

namespace {

const QSizeF viewport(400, 300);

/// Where a world point is seen in the viewport.
QPointF seen(const scene::Camera& camera, glm::vec3 point) {
    const glm::vec4 clip = camera.projection(400, 300) * camera.view() * glm::vec4(point, 1);
    return {(clip.x / clip.w + 1) * 200.0, (1 - clip.y / clip.w) * 150.0};
}

bool near(QPointF a, QPointF b, double tolerance = 0.05) {
    return std::hypot(a.x() - b.x(), a.y() - b.y()) < tolerance;
}

bool near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) {
    return glm::length(a - b) < tolerance;
}

}  // namespace

class NavigationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void gesturesOfThePresets();
    void orbitFollowsTheMouse();
    void orbitStopsAtThePoles();
    void panMovesTheTargetWithTheMouse();
    void zoomKeepsWhatIsUnderTheCursor();
    void zoomStopsAtItsRange();
    void wheelSteps();
    void lightFollowsTheMouse();
    void lightOfTheSphere();
    void numpadViews();
    void picksTheNearestObject();
    void boundsOnTheScreen();
};

void NavigationTest::gesturesOfThePresets() {
    using enum Navigation;
    const auto none = Qt::NoModifier;
    for (const Navigation preset : {Blender, Maya, Trackpad}) {
        QCOMPARE(dragGesture(preset, Qt::LeftButton, none), Gesture::Orbit);
        QCOMPARE(dragGesture(preset, Qt::RightButton, Qt::ShiftModifier), Gesture::Light);
        QCOMPARE(dragGesture(preset, Qt::RightButton, none), Gesture::None);
        QCOMPARE(scrollGesture(preset, Qt::ControlModifier), Gesture::Zoom);
    }
    QCOMPARE(dragGesture(Blender, Qt::MiddleButton, none), Gesture::Orbit);
    QCOMPARE(dragGesture(Blender, Qt::MiddleButton, Qt::ShiftModifier), Gesture::Pan);
    QCOMPARE(dragGesture(Blender, Qt::MiddleButton, Qt::ControlModifier), Gesture::Zoom);
    QCOMPARE(scrollGesture(Blender, none), Gesture::Zoom);
    QCOMPARE(dragGesture(Maya, Qt::LeftButton, Qt::AltModifier), Gesture::Orbit);
    QCOMPARE(dragGesture(Maya, Qt::MiddleButton, Qt::AltModifier), Gesture::Pan);
    QCOMPARE(dragGesture(Maya, Qt::RightButton, Qt::AltModifier), Gesture::Zoom);
    QCOMPARE(dragGesture(Maya, Qt::MiddleButton, none), Gesture::None);
    QCOMPARE(scrollGesture(Trackpad, none), Gesture::Orbit);
    QCOMPARE(scrollGesture(Trackpad, Qt::ShiftModifier), Gesture::Pan);
}

void NavigationTest::orbitFollowsTheMouse() {
    scene::Camera camera;
    camera.azimuth = 170;
    camera.elevation = 0;
    const glm::vec3 front = glm::normalize(camera.position());
    const scene::Camera right = orbited(camera, {50, 0});
    QVERIFY(seen(right, front).x() > seen(camera, front).x());
    QCOMPARE(right.elevation, 0.0f);
    const scene::Camera down = orbited(camera, {0, 50});
    QVERIFY(seen(down, front).y() > seen(camera, front).y());
    // Azimuth stays within half a turn either way: 170 + 40 is -150.
    QCOMPARE(orbited(camera, {-100, 0}).azimuth, -150.0f);
}

void NavigationTest::orbitStopsAtThePoles() {
    scene::Camera camera;
    camera = orbited(camera, {0, 10000});
    QCOMPARE(camera.elevation, 90.0f);
    camera = orbited(camera, {0, -20000});
    QCOMPARE(camera.elevation, -90.0f);
    QVERIFY(std::isfinite(camera.view()[0][0]));
}

void NavigationTest::panMovesTheTargetWithTheMouse() {
    scene::Camera camera;
    camera.distance = 2.5f;
    const glm::vec3 grabbed = camera.target;
    const scene::Camera moved = panned(camera, {37, -21}, viewport);
    QVERIFY(near(seen(moved, grabbed), QPointF(200 + 37, 150 - 21)));
    QCOMPARE(moved.distance, camera.distance);
}

void NavigationTest::zoomKeepsWhatIsUnderTheCursor() {
    scene::Camera camera;
    camera.target = {1, 2, 3};
    const QPointF cursor(330, 80);
    // A point of the target's plane, found by panning it under the cursor.
    const glm::vec3 point = panned(camera, QPointF(200, 150) - cursor, viewport).target;
    QVERIFY(near(seen(camera, point), cursor));
    for (const float factor : {0.5f, 0.9f, 1.7f}) {
        const scene::Camera closer = zoomed(camera, factor, cursor, viewport);
        QVERIFY(near(seen(closer, point), cursor));
        QCOMPARE(closer.distance, camera.distance * factor);
    }
}

void NavigationTest::zoomStopsAtItsRange() {
    const scene::Camera camera;
    const scene::Camera nearest = zoomed(camera, 1e-9f, {10, 10}, viewport);
    QCOMPARE(nearest.distance, 0.01f);
    QCOMPARE(zoomed(nearest, 0.5f, {10, 10}, viewport), nearest);
    QCOMPARE(zoomed(camera, 1e9f, {10, 10}, viewport).distance, 100.0f);
}

void NavigationTest::wheelSteps() {
    QVERIFY(wheelZoomFactor(120) < 1);
    QCOMPARE(wheelZoomFactor(0), 1.0f);
    // Forty small turns are as much as one notch and as a notch the other way takes back.
    QVERIFY(std::abs(std::pow(wheelZoomFactor(3), 40.0f) - wheelZoomFactor(120)) < 1e-4f);
    QVERIFY(std::abs(wheelZoomFactor(120) * wheelZoomFactor(-120) - 1) < 1e-6f);
}

void NavigationTest::lightFollowsTheMouse() {
    scene::Camera camera;
    camera.azimuth = 90;  // looks from +X, so +X is towards the eye and -Z is right
    camera.elevation = 0;
    const glm::vec3 towardsEye(2, 0, 0);
    // 180 pixels turn by 90 degrees.
    QVERIFY(near(turnedLight(towardsEye, camera, {180, 0}), {0, 0, -2}));
    QVERIFY(near(turnedLight(towardsEye, camera, {0, 180}), {0, -2, 0}));
}

void NavigationTest::lightOfTheSphere() {
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    const QSizeF sphere(64, 64);
    QVERIFY(near(lightAt(camera, {32, 32}, sphere), {0, 0, 1}));
    QVERIFY(near(lightAt(camera, {64, 32}, sphere), {1, 0, 0}, 1e-3f));
    QVERIFY(near(lightAt(camera, {32, 0}, sphere), {0, 1, 0}, 1e-3f));
    // Twice the radius away from the centre the light is straight behind.
    QVERIFY(near(lightAt(camera, {96, 32}, sphere), {0, 0, -1}));
    QVERIFY(lightAt(camera, {70, 32}, sphere).z < 0);
}

void NavigationTest::numpadViews() {
    const scene::Camera camera;
    const auto pressed = [&](int key, Qt::KeyboardModifiers modifiers = {}) {
        return keyMoved(camera, key, modifiers | Qt::KeypadModifier, viewport);
    };
    const auto towardsEye = [](const scene::Camera& moved) {
        return glm::normalize(moved.position() - moved.target);
    };
    QVERIFY(near(towardsEye(*pressed(Qt::Key_1)), {0, 0, 1}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_1, Qt::ControlModifier)), {0, 0, -1}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_3)), {1, 0, 0}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_3, Qt::ControlModifier)), {-1, 0, 0}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_7)), {0, 1, 0}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_7, Qt::ControlModifier)), {0, -1, 0}));
    QVERIFY(near(towardsEye(*pressed(Qt::Key_9)), -towardsEye(camera)));
    const scene::Camera flat = *pressed(Qt::Key_5);
    QVERIFY(flat.fieldOfView < camera.fieldOfView);
    QCOMPARE(keyMoved(flat, Qt::Key_5, Qt::KeypadModifier, viewport)->fieldOfView, camera.fieldOfView);
    // The digits of the main keyboard choose the method, elsewhere.
    QVERIFY(!keyMoved(camera, Qt::Key_1, Qt::NoModifier, viewport));
    QVERIFY(!keyMoved(camera, Qt::Key_A, Qt::NoModifier, viewport));
    QVERIFY(keyMoved(camera, Qt::Key_Plus, Qt::NoModifier, viewport)->distance < camera.distance);
}

void NavigationTest::picksTheNearestObject() {
    scene::Scene scene = test::sceneOf(test::squareMesh(), "back");
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform = glm::mat4(0.5f);
    scene.objects[1].transform[3] = {0, 0, 0.5f, 1};  // half as large, nearer to the eye
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    const auto at = [&](QPointF point) { return objectAt(scene, camera, point, viewport); };
    QCOMPARE(at({200, 150}), std::optional<std::size_t>(1));
    QCOMPARE(at(seen(camera, {0.8f, 0.8f, 0})), std::optional<std::size_t>(0));
    QCOMPARE(at({5, 5}), std::nullopt);
    scene.objects[1].visible = false;
    QCOMPARE(at({200, 150}), std::optional<std::size_t>(0));
}

void NavigationTest::boundsOnTheScreen() {
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    const auto boundsOf = [&](glm::vec3 minimum, glm::vec3 maximum) {
        return screenBounds({minimum, maximum}, camera.projection(400, 300) * camera.view(), {400, 300});
    };
    const QRect square = boundsOf({-0.5f, -0.25f, 0}, {0.5f, 0.25f, 0});
    const QRectF exact(seen(camera, {-0.5f, 0.25f, 0}), seen(camera, {0.5f, -0.25f, 0}));
    QVERIFY(QRectF(square).contains(exact));
    QVERIFY(exact.adjusted(-2, -2, 2, 2).contains(QRectF(square)));
    QCOMPARE(boundsOf({-1, -1, -1}, {1, 1, 100}), QRect(0, 0, 400, 300));  // reaches behind the eye
    QVERIFY(boundsOf({50, -1, -1}, {51, 1, 1}).isEmpty());                 // beside the picture
}

}  // namespace chiaro::widgets

QTEST_APPLESS_MAIN(chiaro::widgets::NavigationTest)
#include "viewport_navigation_test.moc"
