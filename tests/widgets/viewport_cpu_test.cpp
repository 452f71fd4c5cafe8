#include "tests/widgets/viewport_support.h"
#include "widgets/viewport/light_sphere.h"

#include <QLabel>
#include <QtTest>

namespace chiaro::widgets {

/// The viewport where there is no OpenGL: the same navigation over the CPU renderer's pictures.
class ViewportCpuTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_viewport.reset(); }
    void saysThatThereIsNoOpenGl();
    void showsCoresPicture();
    void showsCoresImageBasedPicture();
    void showsCoresViewDependentPicture();
    void aSnapshotIsWhatIsShown_data();
    void aSnapshotIsWhatIsShown();
    void tellsWhenThePictureIsAnother();
    void overlaysLieOverThePictureAndUnderTheRest();
    void picturesComeInTheBackground();
    void dragsTurnTheCamera();
    void withoutLevelsTheGradientAloneShows();
    void goesDownDuringARendering();

private:
    QImage shown() { return m_viewport->grab().toImage().convertToFormat(QImage::Format_RGB32); }

    std::unique_ptr<Viewport> m_viewport;
    ViewportPaint m_paint{test::generatedLevels(), test::generatedGradient()};
};

void ViewportCpuTest::init() {
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(320, 240);
    m_viewport->setBackground(glm::vec3(0));
    m_viewport->setPaint(0, m_paint);
    m_viewport->setScene(test::sceneOf(test::sphereMesh()));
    m_viewport->show();
}

void ViewportCpuTest::saysThatThereIsNoOpenGl() {
    QVERIFY(!m_viewport->usesOpenGl());
    const auto* note = m_viewport->findChild<QLabel*>();
    QVERIFY(note && note->isVisible());
    QVERIFY(m_viewport->rect().contains(note->geometry()));
}

void ViewportCpuTest::showsCoresPicture() {
    const QImage picture = m_viewport->picture();
    QCOMPARE(picture.size(), m_viewport->size());
    const test::Reference reference =
        test::referencePicture(test::sceneOf(test::sphereMesh()), m_viewport->camera(), {m_paint},
                               m_viewport->placements(), {}, glm::vec3(0), picture.size());
    QCOMPARE(picture, reference.picture);
}

void ViewportCpuTest::showsCoresImageBasedPicture() {
    m_viewport->setMethod("image-based");
    const auto made = test::imageBasedPicture(test::sceneOf(test::sphereMesh()), m_viewport->camera(),
                                              m_paint.gradient, glm::vec3(0), m_viewport->pixels());
    const QImage untextured = m_viewport->picture();
    QVERIFY(test::meanDifference(untextured, made.reference.picture) > 1);
    m_viewport->setViewTexture(made.texture);
    // But for the 8 bits of its texels.
    QVERIFY(test::meanDifference(m_viewport->picture(), made.reference.picture) < 0.5);
}

void ViewportCpuTest::showsCoresViewDependentPicture() {
    const scene::Scene scene = test::sceneOf(test::sphereMesh());
    m_viewport->setScene(scene);
    m_viewport->setMethod("view-dependent");
    const QImage untextured = m_viewport->picture();
    views::ViewParams views;
    views.count = 4;
    views.size = 96;
    const auto painted = test::paintedObject(scene.objects[0].mesh, views);
    methods::ViewDependentParams params;
    params.followCamera = true;
    m_viewport->setViewDependent(params);
    m_viewport->setPaintedObjects({painted});
    const QImage picture = m_viewport->picture();
    const test::Reference reference = test::viewDependentPicture(
        scene, m_viewport->camera(), {painted}, m_paint.gradient, params, glm::vec3(0), picture.size());
    QCOMPARE(picture, reference.picture);
    QVERIFY(test::meanDifference(untextured, picture) > 1);
}

void ViewportCpuTest::aSnapshotIsWhatIsShown_data() {
    QTest::addColumn<QString>("method");
    for (const std::string& method : drawnMethods())
        QTest::newRow(method.c_str()) << QString::fromStdString(method);
}

void ViewportCpuTest::aSnapshotIsWhatIsShown() {
    QFETCH(QString, method);
    m_viewport->setMethod(method.toStdString());
    if (method == "image-based")
        m_viewport->setViewTexture(test::imageBasedPicture(test::sceneOf(test::sphereMesh()),
                                                           m_viewport->camera(), m_paint.gradient,
                                                           glm::vec3(0), m_viewport->pixels())
                                       .texture);
    scene::Camera camera = m_viewport->camera();
    camera.azimuth += 7;
    m_viewport->setCamera(camera);
    const ViewSnapshot snapshot = m_viewport->snapshots().front();
    const scene::RayScene rays(snapshot.scene);
    const scene::GBuffer gbuffer = scene::castGBuffer(rays, snapshot.scene.lights, snapshot.camera,
                                                      snapshot.pixels.width(), snapshot.pixels.height());
    const methods::Frame frame = shaded(snapshot, gbuffer, 1, {});
    QCOMPARE(test::toQImage(methods::over(frame.picture, snapshot.background)), m_viewport->picture());
}

void ViewportCpuTest::tellsWhenThePictureIsAnother() {
    QSignalSpy spy(m_viewport.get(), &Viewport::pictureChanged);
    m_viewport->setCamera(m_viewport->camera());
    QCOMPARE(spy.count(), 0);
    scene::Camera camera = m_viewport->camera();
    camera.azimuth += 7;
    m_viewport->setCamera(camera);
    QCOMPARE(spy.count(), 1);
    m_viewport->setLights({});
    QCOMPARE(spy.count(), 2);
    m_viewport->resize(300, 200);
    QCOMPARE(spy.count(), 3);
}

void ViewportCpuTest::overlaysLieOverThePictureAndUnderTheRest() {
    auto* mark = new QWidget;
    QPalette red;
    red.setColor(QPalette::Window, Qt::red);
    mark->setPalette(red);
    mark->setAutoFillBackground(true);
    m_viewport->addOverlay(mark);
    mark->show();
    m_viewport->picture();
    QCOMPARE(mark->size(), m_viewport->size());
    QCOMPARE(QColor(shown().pixel(40, 40)), QColor(Qt::red));
    const auto* sphere = m_viewport->findChild<LightSphere*>();
    QVERIFY(QColor(shown().pixel(sphere->geometry().center())) != QColor(Qt::red));
    m_viewport->resize(300, 200);
    QCOMPARE(mark->size(), m_viewport->size());
}

void ViewportCpuTest::picturesComeInTheBackground() {
    QSignalSpy drawn(m_viewport.get(), &Viewport::frameDrawn);
    QTRY_VERIFY(drawn.count() > 0);
    QVERIFY(drawn.at(0).at(0).toDouble() > 0);
    // What the window shows beside its overlays is the fine picture.
    const QRect middle(80, 60, 100, 100);
    QCOMPARE(shown().copy(middle), m_viewport->picture().copy(middle));
}

void ViewportCpuTest::dragsTurnTheCamera() {
    const QImage before = m_viewport->picture();
    QSignalSpy edited(m_viewport.get(), &Viewport::cameraEdited);
    QSignalSpy drawn(m_viewport.get(), &Viewport::frameDrawn);
    QTest::mousePress(m_viewport.get(), Qt::LeftButton, {}, {160, 120});
    for (int x = 165; x <= 260; x += 5) {
        QMouseEvent move(QEvent::MouseMove, QPointF(x, 120), QPointF(x, 120), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(m_viewport.get(), &move);
        QCoreApplication::processEvents();
    }
    QTest::mouseRelease(m_viewport.get(), Qt::LeftButton, {}, {260, 120});
    QCOMPARE(edited.count(), 20);
    QVERIFY(std::abs(m_viewport->camera().azimuth - (30 - 40)) < 1e-3f);
    QTRY_VERIFY(drawn.count() > 0);
    // The last picture is the last camera's.
    const QRect middle(80, 60, 100, 100);
    QTRY_COMPARE(shown().copy(middle), m_viewport->picture().copy(middle));
    QVERIFY(test::meanDifference(before, m_viewport->picture()) > 1);
}

void ViewportCpuTest::withoutLevelsTheGradientAloneShows() {
    m_viewport->setPaint(0, {nullptr, {glm::vec3(0.5f), glm::vec3(0.5f)}});
    const QRgb pixel = m_viewport->picture().pixel(160, 120);
    QCOMPARE(pixel, qRgb(128, 128, 128));
}

void ViewportCpuTest::goesDownDuringARendering() {
    m_viewport->setScene(test::sceneOf(test::sphereMesh(400)));
    QTest::qWait(5);
    QElapsedTimer timer;
    timer.start();
    m_viewport.reset();
    QVERIFY2(timer.elapsed() < 1000, qPrintable(QString::number(timer.elapsed())));
}

}  // namespace chiaro::widgets

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("QT_SCALE_FACTOR", "1");
    QApplication app(argc, argv);
    chiaro::widgets::ViewportCpuTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "viewport_cpu_test.moc"
