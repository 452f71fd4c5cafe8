#include "core/methods/level_texels.h"
#include "core/methods/object_texels.h"
#include "core/scene/mesh_io.h"
#include "tests/support/support.h"
#include "tests/widgets/viewport_support.h"
#include "widgets/viewport/frame_drawer.h"
#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/gl_view.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLVersionFunctionsFactory>
#include <QtTest>

namespace chiaro::widgets {

namespace {

constexpr glm::vec3 background(0.1f, 0.2f, 0.3f);

scene::Scene demoScene(const QString& file) {
    scene::Scene scene;
    for (scene::Mesh& mesh : scene::readModel(test::resource("demo/meshes/" + file.toStdString())).meshes) {
        const std::string name = mesh.name;
        scene.objects.push_back(test::sceneOf(std::move(mesh), name).objects[0]);
    }
    return scene;
}

}  // namespace

/// The viewport drawn by OpenGL; everything is skipped, saying so, where there is none.
class ViewportGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void texelsKeepTheDifferences();
    void drawsWhatTheCpuDraws_data();
    void drawsWhatTheCpuDraws();
    void drawsTheDemoMeshesAsTheCpuDoes_data();
    void drawsTheDemoMeshesAsTheCpuDoes();
    void drawsImageBasedAsTheCpuDoes_data();
    void drawsImageBasedAsTheCpuDoes();
    void drawsViewDependentAsTheCpuDoes_data();
    void drawsViewDependentAsTheCpuDoes();
    void largeMapsTakePagesOrShrink();
    void objectsWithoutTexturesShowTheGradient();
    void movesTheTextureWithItsObject();
    void fadesFromTextureToTexture();
    void silhouettesAreSmooth();
    void gradientChangesWithoutTheTexture();
    void withoutLevelsTheGradientAloneShows();
    void levelsComeInTheBackground();
    void orbitDragTurnsTheCamera();
    void panDragMovesObjectAndTexture();
    void resizingKeepsTheStrokes();
    void wheelZooms();
    void shiftRightDragTurnsTheLight();
    void lightSphereTurnsTheLight();
    void dragsTurnTheChosenLightAroundTheTarget();
    void shadowsAreDrawnByTheCpu();
    void keysFrame();
    void anotherContextGivesTheSamePicture();
    void sameObjectKeepsItsPlacement();
    void tellsFramesAndDrops();

private:
    void show(const scene::Scene& scene);
    double differenceFromCpu(const scene::Scene& scene);
    QPoint centre() const { return m_viewport->rect().center(); }
    void drag(QPoint from, QPoint by, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});

    std::unique_ptr<Viewport> m_viewport;
    std::vector<ViewportPaint> m_paints;
    methods::ViewAlignedParams m_params;
};

void ViewportGlTest::initTestCase() {
    if (!openGlSupport().usable) QSKIP("no OpenGL 4.1 here");
    QVERIFY(openGlSupport().samples >= 4);
    m_paints = {{test::generatedLevels(), test::generatedGradient()},
                {test::generatedLevels(3, 96), {{0.3f, 0, 0}, {1, 0.9f, 0.2f}}}};
}

void ViewportGlTest::init() {
    m_params = {};
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(480, 360);
    m_viewport->setBackground(background);
    for (std::size_t i = 0; i < m_paints.size(); ++i) m_viewport->setPaint(int(i), m_paints[i]);
}

void ViewportGlTest::cleanup() {
    m_viewport.reset();
}

void ViewportGlTest::show(const scene::Scene& scene) {
    m_viewport->setScene(scene);
    m_viewport->setParams(m_params);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    QVERIFY(m_viewport->usesOpenGl());
}

double ViewportGlTest::differenceFromCpu(const scene::Scene& scene) {
    const QImage drawn = m_viewport->picture();
    const test::Reference reference = test::referencePicture(
        scene, m_viewport->camera(), m_paints, m_viewport->placements(), m_params, background, drawn.size());
    const QString name = QString("%1_%2").arg(QTest::currentTestFunction(), QTest::currentDataTag());
    test::keepPicture(drawn, name + "_gl");
    test::keepPicture(reference.picture, name + "_cpu");
    const double inside = test::meanDifference(drawn, reference.picture,
                                               [&](int x, int y) { return reference.inside(x, y) != 0; });
    qInfo("difference from the CPU's picture: %.3f/255 inside the objects, %.3f/255 over all", inside,
          test::meanDifference(drawn, reference.picture));
    return inside;
}

void ViewportGlTest::drag(QPoint from, QPoint by, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(m_viewport.get(), button, modifiers, from);
    // QTest::mouseMove tells no buttons, so the moves are made here.
    for (int step = 1; step <= 4; ++step) {
        const QPointF at = QPointF(from) + QPointF(by) * step / 4;
        QMouseEvent move(QEvent::MouseMove, at, m_viewport->mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(m_viewport.get(), &move);
    }
    QTest::mouseRelease(m_viewport.get(), button, modifiers, from + by);
}

void ViewportGlTest::texelsKeepTheDifferences() {
    synthesis::LevelStack stack;
    stack.levels.assign(2, ColorImage(2, 2, glm::vec3(0)));
    stack.levels[1](1, 0) = {0.5f, -0.5f, 0.1f};
    const methods::LevelTexels texels = methods::levelTexels(stack);
    QCOMPARE(texels.size, 2);
    QCOMPARE(texels.count, 2);
    const auto difference = [&](std::size_t texel, int channel) {
        return texels.range.difference(texels.texels[texel])[channel];
    };
    QVERIFY(std::abs(difference(0, 0)) < 1e-6f);  // no difference stays none
    QVERIFY(std::abs(difference(5, 0) - 0.5f) < 1e-6f);
    QVERIFY(std::abs(difference(5, 1) + 0.5f) < 1e-6f);
    QVERIFY(std::abs(difference(5, 2) - 0.1f) <= 0.5f / 127 / 2 + 1e-6f);
}

void ViewportGlTest::drawsWhatTheCpuDraws_data() {
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<double>("density");
    QTest::addColumn<float>("distance");
    QTest::addColumn<float>("azimuth");
    QTest::newRow("sphere") << "sphere" << 1.0 << 1.2f << 30.0f;
    QTest::newRow("coarse strokes") << "sphere" << 0.37 << 1.2f << -100.0f;
    QTest::newRow("fine strokes") << "sphere" << 1.7 << 1.2f << 200.0f;
    QTest::newRow("finest strokes") << "sphere" << 5.0 << 1.2f << 0.0f;
    QTest::newRow("close by") << "sphere" << 1.0 << 0.45f << 0.0f;
    QTest::newRow("square") << "square" << 1.0 << 1.1f << 20.0f;
    QTest::newRow("square from behind") << "square" << 1.0 << 1.1f << 160.0f;
    QTest::newRow("mirrored") << "mirrored" << 1.0 << 1.1f << 20.0f;
    QTest::newRow("two paints") << "two" << 1.0 << 1.0f << 30.0f;
    QTest::newRow("lights at points") << "points" << 1.0 << 1.0f << 30.0f;
}

void ViewportGlTest::drawsWhatTheCpuDraws() {
    QFETCH(QString, mesh);
    QFETCH(double, density);
    QFETCH(float, distance);
    QFETCH(float, azimuth);
    const bool flat = mesh == "square" || mesh == "mirrored";
    scene::Scene scene = test::sceneOf(flat ? test::squareMesh() : test::sphereMesh());
    if (mesh == "mirrored") scene.objects[0].transform[2][2] = -1;
    if (mesh == "two") {
        scene.objects.push_back(scene.objects[0]);
        scene.objects[1].name = "second";
        scene.objects[1].sample = 1;
        scene.objects[1].transform[3] = {0.7f, 0.5f, 0.8f, 1};
        scene.lights = {{.vector = {1, 0, 0.3f}, .intensity = 0.6f},
                        {.vector = {-1, 2, 1}, .intensity = 0.8f, .wrap = false}};
    }
    if (mesh == "points") {
        scene.objects[0].transform[3] = {0.1f, -0.2f, 0, 1};
        scene.lights = {{.kind = scene::Light::Kind::Point, .vector = {1.5f, 1, 2}, .intensity = 0.7f},
                        {.kind = scene::Light::Kind::Point, .vector = {-2, 0.5f, 1}, .wrap = false},
                        {.vector = {0, 1, 0}, .visible = false},
                        {.vector = {0, 1, 0.5f}, .intensity = 0.2f, .wrap = false}};
    }
    m_params.density = density;
    scene::Camera camera;
    camera.azimuth = azimuth;
    camera.distance = 1.2f;
    m_viewport->setCamera(camera);
    show(scene);
    m_viewport->picture();
    // A move after the objects were seen once, so that offset and zoom are not what they began with.
    camera.distance = distance;
    camera.azimuth += 3;
    m_viewport->setCamera(camera);
    QVERIFY(differenceFromCpu(scene) < 2);
}

void ViewportGlTest::drawsTheDemoMeshesAsTheCpuDoes_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("shell") << "shell.ply";
    QTest::newRow("still life") << "still_life.obj";
    QTest::newRow("skull") << "skull.glb";
}

void ViewportGlTest::drawsTheDemoMeshesAsTheCpuDoes() {
    QFETCH(QString, file);
    const scene::Scene scene = demoScene(file);
    m_viewport->resize(640, 480);
    show(scene);
    m_viewport->frameAll();
    QVERIFY(differenceFromCpu(scene) < 2);
}

void ViewportGlTest::drawsImageBasedAsTheCpuDoes_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("two spheres") << "";
    QTest::newRow("shell") << "shell.ply";
    QTest::newRow("still life") << "still_life.obj";
    QTest::newRow("skull") << "skull.glb";
}

void ViewportGlTest::drawsImageBasedAsTheCpuDoes() {
    QFETCH(QString, file);
    scene::Scene scene = test::sceneOf(test::sphereMesh(), "first");
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].name = "second";
    scene.objects[1].transform[3] = {0.7f, 0.5f, 0.8f, 1};
    if (!file.isEmpty()) scene = demoScene(file);
    m_viewport->resize(640, 480);
    m_viewport->setMethod("image-based");
    show(scene);
    m_viewport->frameAll();
    const auto made = test::imageBasedPicture(scene, m_viewport->camera(), m_paints[0].gradient, background,
                                              m_viewport->pixels());
    const QImage untextured = m_viewport->picture();
    m_viewport->setViewTexture(made.texture);
    const QImage drawn = m_viewport->picture();
    test::keepPicture(drawn, QString("image_based_%1_gl").arg(QTest::currentDataTag()));
    test::keepPicture(made.reference.picture, QString("image_based_%1_cpu").arg(QTest::currentDataTag()));
    const auto inside = [&](int x, int y) { return made.reference.inside(x, y) != 0; };
    const double difference = test::meanDifference(drawn, made.reference.picture, inside);
    qInfo("difference from the CPU's picture: %.3f/255 inside the objects, %.3f/255 over all", difference,
          test::meanDifference(drawn, made.reference.picture));
    QVERIFY(difference < 2);
    QVERIFY(test::meanDifference(untextured, made.reference.picture, inside) > 3);
    // Another light keeps the texture, another gradient too.
    m_viewport->setGradient(0, {glm::vec3(0.5f), glm::vec3(0.5f)});
    const QImage texture = m_viewport->picture();
    m_viewport->setLights({{.vector = {1, 0, 0}}});
    QVERIFY(test::meanDifference(texture, m_viewport->picture(), inside) < 0.05);
}

void ViewportGlTest::drawsViewDependentAsTheCpuDoes_data() {
    using views::Projection;
    QTest::addColumn<QString>("file");
    QTest::addColumn<Projection>("projection");
    QTest::addColumn<bool>("followCamera");
    QTest::addColumn<methods::Blend>("blend");
    const auto linear = methods::Blend::Linear;
    QTest::newRow("two spheres") << "" << Projection::Orthographic << false << linear;
    QTest::newRow("perspective maps") << "" << Projection::Perspective << false << linear;
    QTest::newRow("following the camera") << "" << Projection::Orthographic << true << linear;
    QTest::newRow("preserving") << "" << Projection::Perspective << true << methods::Blend::Preserving;
    QTest::newRow("square") << "square" << Projection::Perspective << false << linear;
    QTest::newRow("mirrored square") << "mirrored" << Projection::Orthographic << false << linear;
    QTest::newRow("still life") << "still_life.obj" << Projection::Orthographic << false << linear;
    QTest::newRow("shell") << "shell.ply" << Projection::Orthographic << false << linear;
}

void ViewportGlTest::drawsViewDependentAsTheCpuDoes() {
    QFETCH(QString, file);
    QFETCH(views::Projection, projection);
    QFETCH(bool, followCamera);
    QFETCH(methods::Blend, blend);
    const bool flat = file == "square" || file == "mirrored";
    scene::Scene scene = test::sceneOf(flat ? test::squareMesh() : test::sphereMesh());
    if (file == "mirrored") scene.objects[0].transform[2][2] = -1;
    if (file.isEmpty()) {
        scene.objects.push_back(test::sceneOf(test::sphereMesh(24), "second").objects[0]);
        scene.objects[1].transform = glm::scale(glm::mat4(1), glm::vec3(0.5f, 0.7f, 0.6f));
        scene.objects[1].transform[3] = {0.7f, 0.5f, 0.8f, 1};
    }
    if (file.contains('.')) scene = demoScene(file);
    views::ViewParams views;
    views.count = 8;
    views.size = 160;
    views.projection = projection;
    std::vector<std::shared_ptr<const methods::PaintedObject>> painted;
    for (const scene::Object& object : scene.objects)
        painted.push_back(test::paintedObject(object.mesh, views));
    methods::ViewDependentParams params;
    params.followCamera = followCamera;
    params.blend = blend;
    m_viewport->resize(640, 480);
    m_viewport->setMethod("view-dependent");
    m_viewport->setViewDependent(params);
    scene::Camera camera;
    camera.azimuth = 25;
    camera.elevation = 20;
    m_viewport->setCamera(camera);
    show(scene);
    m_viewport->frameAll();
    const QImage untextured = m_viewport->picture();
    m_viewport->setPaintedObjects(painted);
    const QImage drawn = m_viewport->picture();
    const test::Reference reference = test::viewDependentPicture(
        scene, m_viewport->camera(), painted, m_paints[0].gradient, params, background, drawn.size());
    test::keepPicture(drawn, QString("view_dependent_%1_gl").arg(QTest::currentDataTag()));
    test::keepPicture(reference.picture, QString("view_dependent_%1_cpu").arg(QTest::currentDataTag()));
    const auto inside = [&](int x, int y) { return reference.inside(x, y) != 0; };
    const double difference = test::meanDifference(drawn, reference.picture, inside);
    qInfo("difference from the CPU's picture: %.3f/255 inside the objects, %.3f/255 over all", difference,
          test::meanDifference(drawn, reference.picture));
    QVERIFY(difference < 2);
    QVERIFY(test::meanDifference(untextured, reference.picture, inside) > 3);
}

void ViewportGlTest::largeMapsTakePagesOrShrink() {
    views::ViewParams views;
    views.count = 6;
    views.size = 128;
    const auto mesh = test::sceneOf(test::sphereMesh(24)).objects[0].mesh;
    const auto painted = test::paintedObject(mesh, views);
    const methods::ObjectTexels whole = methods::objectTexels(*painted, 2048);
    QCOMPARE(whole.layout.pageCount, 1);
    QCOMPARE(whole.layout.levelCount, 8);
    QCOMPARE(whole.corners.size(), 3 * mesh->triangles.size());
    // A side that holds at most four maps a page.
    const methods::ObjectTexels paged = methods::objectTexels(*painted, 270);
    QVERIFY(paged.layout.pageCount > 1);
    QCOMPARE(paged.layout.size.z, 8 * paged.layout.pageCount);
    QCOMPARE(paged.views[3].w * float(paged.layout.pageCount),
             std::round(paged.views[3].w * float(paged.layout.pageCount)));
    QVERIFY(paged.layout.size.x <= 270 && paged.layout.size.y <= 270);
    const methods::ObjectTexels small = methods::objectTexels(*painted, 2048, whole.textureBytes() / 3);
    QVERIFY(small.textureBytes() <= whole.textureBytes() / 3);
    QVERIFY(small.textureBytes() > whole.textureBytes() / 6);
    // The middle of a map is the same place of the object in all of them.
    const auto coordinates = [](const methods::ObjectTexels& texels, std::size_t view, glm::vec3 point) {
        return glm::vec2(
            glm::dot(texels.views[view * 4], glm::vec4(point, 1)) * float(texels.layout.size.x),
            glm::dot(texels.views[view * 4 + 1], glm::vec4(point, 1)) * float(texels.layout.size.y));
    };
    for (std::size_t view = 0; view < 6; ++view) {
        const glm::vec2 texel = coordinates(whole, view, {0.3f, 0.2f, 0.1f}) - coordinates(whole, view, {});
        const glm::vec2 half = coordinates(small, view, {0.3f, 0.2f, 0.1f}) - coordinates(small, view, {});
        QVERIFY(glm::length(texel - 2.0f * half) < 1e-3f);
    }
}

void ViewportGlTest::objectsWithoutTexturesShowTheGradient() {
    const scene::Scene scene = test::sceneOf(test::sphereMesh());
    show(scene);
    m_viewport->setPaint(0, {nullptr, m_paints[0].gradient});
    const QImage gradientOnly = m_viewport->picture();
    m_viewport->setMethod("view-dependent");
    QVERIFY(test::meanDifference(m_viewport->picture(), gradientOnly) < 0.01);
    // Textures of another mesh are not shown.
    views::ViewParams views;
    views.count = 3;
    views.size = 64;
    const auto other = std::make_shared<const scene::Mesh>(test::sphereMesh(16));
    m_viewport->setPaintedObjects({test::paintedObject(other, views)});
    QVERIFY(test::meanDifference(m_viewport->picture(), gradientOnly) < 0.01);
    m_viewport->setPaintedObjects({test::paintedObject(scene.objects[0].mesh, views)});
    QVERIFY(test::meanDifference(m_viewport->picture(), gradientOnly) > 1);
    m_viewport->setPaintedObjects({});
    QVERIFY(test::meanDifference(m_viewport->picture(), gradientOnly) < 0.01);
}

void ViewportGlTest::movesTheTextureWithItsObject() {
    const scene::Scene scene = test::sceneOf(test::sphereMesh());
    m_viewport->setMethod("image-based");
    m_viewport->setLights({{.vector = {0, 0, 1}}});
    show(scene);
    const auto made = test::imageBasedPicture(scene, m_viewport->camera(), m_paints[0].gradient, background,
                                              m_viewport->pixels());
    m_viewport->setViewTexture(made.texture);
    m_viewport->setGradient(0, {glm::vec3(0.5f), glm::vec3(0.5f)});
    const QImage before = m_viewport->picture();
    scene::Camera camera = m_viewport->camera();
    camera.azimuth += 25;
    m_viewport->setCamera(camera);
    const QImage turned = m_viewport->picture();
    // What came into view wears texture too: nothing of the middle's contrast is lost anywhere.
    const auto contrast = [](const QImage& image, QRect area) {
        double sum = 0;
        for (int y = area.top(); y <= area.bottom(); ++y)
            for (int x = area.left(); x <= area.right(); ++x) sum += std::abs(qGray(image.pixel(x, y)) - 128);
        return sum / area.width() / area.height();
    };
    const QPoint middle = before.rect().center();
    const int reach = before.height() * 2 / 5;
    for (const QPoint at : {QPoint(-reach, 0), QPoint(reach, 0), QPoint(0, -reach), QPoint(0, reach)}) {
        const QRect area(middle + at - QPoint(10, 10), QSize(20, 20));
        QVERIFY(contrast(turned, area) > 0.5 * contrast(before, area));
    }
    // A pan takes the strokes along: they are found again where the object is.
    m_viewport->setCamera(made.texture->camera);
    drag(centre(), {40, 0}, Qt::MiddleButton, Qt::ShiftModifier);
    const QImage panned = m_viewport->picture();
    const QRect patch(middle - QPoint(40, 40), QSize(80, 80));
    double best = 255;
    for (int shift = 0; shift < before.width() / 4; ++shift)
        best =
            std::min(best, test::meanDifference(before.copy(patch), panned.copy(patch.translated(shift, 0))));
    const double unmoved = test::meanDifference(before.copy(patch), panned.copy(patch));
    QVERIFY2(best < 0.4 * unmoved, qPrintable(QString("best %1, unmoved %2").arg(best).arg(unmoved)));
}

void ViewportGlTest::fadesFromTextureToTexture() {
    QOpenGLContext context;
    context.setFormat(openGlFormat());
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    QVERIFY(context.create() && context.makeCurrent(&surface));
    Gl& gl = *QOpenGLVersionFunctionsFactory::get<Gl>(&context);
    FrameDrawer drawer;
    QVERIFY(drawer.initialize(gl));
    const QSize pixels(160, 120);
    QOpenGLFramebufferObject target(pixels);
    ViewState state;
    state.setMethod("image-based");
    state.setScene(test::sceneOf(test::sphereMesh()));
    state.setPaint(0, m_paints[0]);
    const auto first =
        test::imageBasedPicture(state.scene(), state.camera, m_paints[0].gradient, background, pixels)
            .texture;
    auto inverse = std::make_shared<ViewTexture>(*first);
    for (methods::DifferenceTexel& texel : inverse->objects[0].texels.pixels())
        for (int i = 0; i < 3; ++i) texel[std::size_t(i)] = std::uint8_t(256 - texel[std::size_t(i)]);
    const auto draw = [&](const auto& shown, const auto& earlier, float weight) {
        state.viewTexture = shown;
        state.earlierTexture = earlier;
        state.earlierWeight = weight;
        drawer.draw(gl, state, state.method(), pixels, target.handle());
        return target.toImage().convertToFormat(QImage::Format_RGB32);
    };
    using Texture = std::shared_ptr<const ViewTexture>;
    const QImage before = draw(first, Texture(), 0);
    const QImage after = draw(Texture(inverse), Texture(first), 0);
    QVERIFY(test::meanDifference(before, after) > 1);
    QVERIFY(test::meanDifference(draw(Texture(inverse), Texture(first), 1), before) < 0.1);
    // Half way a texture and its inverse cancel out: G(L) alone is left.
    const QImage between = draw(Texture(inverse), Texture(first), 0.5f);
    QVERIFY(test::meanDifference(between, draw(Texture(), Texture(), 0)) < 0.1);
    // An earlier texture that was never shown has nothing to fade from.
    QCOMPARE(draw(Texture(inverse), std::make_shared<const ViewTexture>(*first), 0.5f), after);
    drawer.release(gl);
}

void ViewportGlTest::silhouettesAreSmooth() {
    const scene::Scene scene = test::sceneOf(test::squareMesh());
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 30;
    camera.distance = 1.5f;
    m_viewport->setPaint(0, {nullptr, {glm::vec3(1), glm::vec3(1)}});
    m_viewport->setBackground(glm::vec3(0));
    m_viewport->setCamera(camera);
    show(scene);
    const QImage drawn = m_viewport->picture();
    std::set<int> values;
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) values.insert(qRed(drawn.pixel(x, y)));
    // Black, white, and what lies between where an edge crosses a pixel.
    QVERIFY(values.contains(0));
    QVERIFY(values.contains(255));
    QVERIFY2(values.size() >= 5, qPrintable(QString::number(values.size())));
}

void ViewportGlTest::gradientChangesWithoutTheTexture() {
    const scene::Scene scene = test::sceneOf(test::sphereMesh());
    show(scene);
    const QImage before = m_viewport->picture();
    const gradient::Gradient recolored{{0.2f, 0, 0.2f}, {0.2f, 0.9f, 0.4f}, {1, 1, 0.8f}};
    m_viewport->setGradient(0, recolored);
    QVERIFY(test::meanDifference(before, m_viewport->picture()) > 5);
    const ViewportPaint kept = std::exchange(m_paints[0], {m_paints[0].levels, recolored});
    const double difference = differenceFromCpu(scene);
    m_paints[0] = kept;
    QVERIFY(difference < 2);
    m_viewport->setGradient(0, kept.gradient);
    QCOMPARE(m_viewport->picture(), before);
}

void ViewportGlTest::withoutLevelsTheGradientAloneShows() {
    scene::Scene scene = test::sceneOf(test::squareMesh());
    scene.lights = {{.vector = {0, 0, 1}}};  // L = 1 all over the square
    m_viewport->setPaint(0, {nullptr, {{0, 0, 0}, {1, 0.5f, 0.25f}}});
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    m_viewport->setCamera(camera);
    show(scene);
    const QImage drawn = m_viewport->picture();
    const QRgb pixel = drawn.pixel(drawn.rect().center());
    QCOMPARE(qRed(pixel), 255);
    QVERIFY(std::abs(qGreen(pixel) - 128) <= 1);
    QVERIFY(std::abs(qBlue(pixel) - 64) <= 1);
}

void ViewportGlTest::levelsComeInTheBackground() {
    m_viewport->setPaint(0, {nullptr, m_paints[0].gradient});
    show(test::sceneOf(test::sphereMesh()));
    const auto middle = [this] { return m_viewport->grab().toImage().copy(150, 100, 100, 100); };
    const QImage untextured = middle();
    m_viewport->setPaint(0, m_paints[0]);
    QTRY_VERIFY(test::meanDifference(untextured, middle()) > 3);
    // The same levels again are no news, another stack is.
    const QImage textured = middle();
    m_viewport->setPaint(0, m_paints[0]);
    QCOMPARE(middle(), textured);
    m_viewport->setPaint(0, {test::generatedLevels(2, 64), m_paints[0].gradient});
    QTRY_VERIFY(test::meanDifference(textured, middle()) > 3);
}

void ViewportGlTest::orbitDragTurnsTheCamera() {
    show(test::sceneOf(test::sphereMesh()));
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton}) {
        const scene::Camera before = m_viewport->camera();
        const QImage picture = m_viewport->picture();
        QSignalSpy edited(m_viewport.get(), &Viewport::cameraEdited);
        drag(centre(), {40, 20}, button);
        QCOMPARE(edited.count(), 4);
        QCOMPARE(edited.last().at(0).value<scene::Camera>(), m_viewport->camera());
        QVERIFY(std::abs(m_viewport->camera().azimuth - (before.azimuth - 16)) < 1e-3f);
        QVERIFY(std::abs(m_viewport->camera().elevation - (before.elevation + 8)) < 1e-3f);
        QVERIFY(test::meanDifference(picture, m_viewport->picture()) > 1);
    }
    const scene::Camera before = m_viewport->camera();
    drag(centre(), {40, 20}, Qt::RightButton);
    QCOMPARE(m_viewport->camera(), before);
}

void ViewportGlTest::panDragMovesObjectAndTexture() {
    show(test::sceneOf(test::sphereMesh()));
    m_viewport->picture();
    const double ratio = m_viewport->devicePixelRatioF();
    QCOMPARE(m_viewport->placements().at(0), methods::TexturePlacement{});
    drag(centre(), {32, -20}, Qt::MiddleButton, Qt::ShiftModifier);
    m_viewport->picture();
    const methods::TexturePlacement moved = m_viewport->placements().at(0);
    // The vertices that face the camera lie nearer than the target's plane, so they move a little further.
    QVERIFY2(moved.offset.x > 32 * ratio && moved.offset.x < 48 * ratio,
             qPrintable(QString::number(moved.offset.x)));
    QVERIFY(moved.offset.y < -20 * ratio && moved.offset.y > -30 * ratio);
    QVERIFY(std::abs(moved.zoom - 1) < 0.02f);
}

void ViewportGlTest::resizingKeepsTheStrokes() {
    show(test::sceneOf(test::sphereMesh()));
    m_viewport->picture();
    m_viewport->resize(700, 520);
    QCoreApplication::processEvents();
    m_viewport->picture();
    QCOMPARE(m_viewport->placements().at(0).zoom, 1.0f);
    QVERIFY(m_viewport->placements().at(0).offset != glm::vec2(0));
}

void ViewportGlTest::wheelZooms() {
    show(test::sceneOf(test::sphereMesh()));
    m_viewport->picture();
    const auto turn = [this](int eighths, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF at = centre();
        QWheelEvent wheel(at, m_viewport->mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_viewport.get(), &wheel);
    };
    const scene::Camera start = m_viewport->camera();
    turn(120);
    const float afterNotch = m_viewport->camera().distance;
    QVERIFY(afterNotch < start.distance);
    m_viewport->picture();
    QVERIFY(m_viewport->placements().at(0).zoom > 1.05f);
    m_viewport->setCamera(start);
    for (int i = 0; i < 8; ++i) turn(15);
    QVERIFY(std::abs(m_viewport->camera().distance - afterNotch) < 1e-4f);

    m_viewport->setNavigation(Viewport::Navigation::Trackpad);
    const scene::Camera before = m_viewport->camera();
    turn(120);
    QCOMPARE(m_viewport->camera().distance, before.distance);
    QVERIFY(m_viewport->camera().elevation != before.elevation);
    turn(120, Qt::ControlModifier);
    QVERIFY(m_viewport->camera().distance < before.distance);
}

void ViewportGlTest::shiftRightDragTurnsTheLight() {
    show(test::sceneOf(test::sphereMesh()));
    const QImage before = m_viewport->picture();
    const scene::Camera camera = m_viewport->camera();
    QSignalSpy edited(m_viewport.get(), &Viewport::lightEdited);
    QSignalSpy finished(m_viewport.get(), &Viewport::lightEditFinished);
    drag(centre(), {100, 0}, Qt::RightButton, Qt::ShiftModifier);
    QCOMPARE(edited.count(), 4);
    QCOMPARE(edited.last().at(0).toInt(), 0);
    const auto vector = edited.last().at(1).value<glm::vec3>();
    const glm::vec3 start = scene::Light{}.vector;
    QVERIFY(std::abs(glm::length(vector) - glm::length(start)) < 1e-4f);
    // The lit side went right.
    QVERIFY(glm::dot(vector, camera.basis()[0]) > glm::dot(start, camera.basis()[0]));
    QCOMPARE(finished.count(), 1);
    QCOMPARE(m_viewport->camera(), camera);
    QVERIFY(test::meanDifference(before, m_viewport->picture()) > 1);
}

void ViewportGlTest::lightSphereTurnsTheLight() {
    show(test::sceneOf(test::sphereMesh()));
    QWidget* sphere = nullptr;
    for (QWidget* child : m_viewport->findChildren<QWidget*>())
        if (child->accessibleName() == "Light") sphere = child;
    QVERIFY(sphere && sphere->isVisible());
    QSignalSpy edited(m_viewport.get(), &Viewport::lightEdited);
    QSignalSpy finished(m_viewport.get(), &Viewport::lightEditFinished);
    QTest::mouseClick(sphere, Qt::LeftButton, {}, sphere->rect().center() + QPoint(1, 1));
    QCOMPARE(edited.count(), 1);
    QCOMPARE(finished.count(), 1);
    // A click on the middle puts the light behind the eye.
    const auto vector = glm::normalize(edited.at(0).at(1).value<glm::vec3>());
    QVERIFY(glm::dot(vector, m_viewport->camera().basis()[2]) > 0.99f);
}

void ViewportGlTest::dragsTurnTheChosenLightAroundTheTarget() {
    scene::Scene scene = test::sceneOf(test::sphereMesh());
    scene.lights = {{}, {.kind = scene::Light::Kind::Point, .vector = {10, 0, 3}}};
    show(scene);
    scene::Camera camera = m_viewport->camera();
    camera.target = {10, 0, 0};
    m_viewport->setCamera(camera);
    m_viewport->setTurnedLight(1);
    QSignalSpy edited(m_viewport.get(), &Viewport::lightEdited);
    drag(centre(), {40, 10}, Qt::RightButton, Qt::ShiftModifier);
    QVERIFY(!edited.isEmpty());
    QCOMPARE(edited.last().at(0).toInt(), 1);
    const auto moved = edited.last().at(1).value<glm::vec3>();
    QVERIFY(moved != scene.lights[1].vector);
    QVERIFY(std::abs(glm::distance(moved, camera.target) - 3) < 1e-4f);
    m_viewport->setTurnedLight(7);  // there is none
    edited.clear();
    drag(centre(), {40, 10}, Qt::RightButton, Qt::ShiftModifier);
    QVERIFY(edited.isEmpty());
}

void ViewportGlTest::shadowsAreDrawnByTheCpu() {
    scene::Scene scene = test::sceneOf(test::sphereMesh());
    scene.objects.push_back(test::sceneOf(test::squareMesh(), "wall").objects[0]);
    scene.objects[1].transform = glm::mat4(glm::mat3(3));
    scene.objects[1].transform[3] = {0, 0, -1.5f, 1};
    scene.lights = {{.vector = {0.5f, 0.3f, 1}, .wrap = false}};
    show(scene);
    QVERIFY(m_viewport->usesOpenGl());
    const QImage open = m_viewport->picture();
    scene.occlusion.shadows = true;
    m_viewport->setScene(scene);
    QVERIFY(!m_viewport->usesOpenGl());
    const auto* note = m_viewport->findChild<QLabel*>();
    QVERIFY(note && note->isVisible() && note->text().contains("Shadows"));
    QVERIFY(differenceFromCpu(scene) < 0.5);
    QVERIFY(m_viewport->picture() != open);
    scene.occlusion.shadows = false;
    m_viewport->setScene(scene);
    QVERIFY(m_viewport->usesOpenGl());
    QVERIFY(!note->isVisible());
    QCOMPARE(m_viewport->picture(), open);
}

void ViewportGlTest::keysFrame() {
    scene::Scene scene = test::sceneOf(test::sphereMesh(), "one");
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].name = "two";
    scene.objects[1].transform[3] = {10, 0, 0, 1};
    show(scene);
    QSignalSpy edited(m_viewport.get(), &Viewport::cameraEdited);
    QTest::keyClick(m_viewport.get(), Qt::Key_Home);
    QCOMPARE(edited.count(), 1);
    QVERIFY(glm::length(m_viewport->camera().target - glm::vec3(5, 0, 0)) < 1e-4f);
    QVERIFY(m_viewport->camera().radius > 5);
    // F frames what lies under the cursor.
    scene::Camera camera = m_viewport->camera();
    camera.target = {10, 0, 0};
    m_viewport->setCamera(camera);
    QCursor::setPos(m_viewport->mapToGlobal(centre()));
    QTRY_COMPARE(QCursor::pos(), m_viewport->mapToGlobal(centre()));
    QTest::keyClick(m_viewport.get(), Qt::Key_F);
    QVERIFY(glm::length(m_viewport->camera().target - glm::vec3(10, 0, 0)) < 1e-4f);
    QVERIFY(m_viewport->camera().radius < 2);
}

void ViewportGlTest::anotherContextGivesTheSamePicture() {
    const scene::Scene scene = test::sceneOf(test::sphereMesh());
    show(scene);
    const QImage before = m_viewport->picture();
    auto* view = m_viewport->findChild<GlView*>();
    const QSize size = m_viewport->size();
    QPointer<QOpenGLContext> first = view->context();
    QWidget other;
    // Taken out again before `other` goes, whatever fails.
    const auto takeOut = qScopeGuard([this] { m_viewport->setParent(nullptr); });
    m_viewport->setParent(&other);
    m_viewport->resize(size);
    m_viewport->show();
    other.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    QVERIFY(first.isNull());  // gone, so the picture comes from another one
    QVERIFY(view->context());
    QCOMPARE(m_viewport->picture(), before);
    m_viewport->setParent(nullptr);
    m_viewport->resize(size);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    QCOMPARE(m_viewport->picture(), before);
}

void ViewportGlTest::sameObjectKeepsItsPlacement() {
    scene::Scene scene = test::sceneOf(test::sphereMesh());
    show(scene);
    m_viewport->picture();
    scene.objects[0].transform[3] = {0.2f, 0, 0, 1};
    m_viewport->setScene(scene);
    m_viewport->picture();
    const methods::TexturePlacement moved = m_viewport->placements().at(0);
    QVERIFY(moved.offset.x > 5);
    // Another object comes in before it.
    scene.objects.insert(scene.objects.begin(), test::sceneOf(test::squareMesh(), "new").objects[0]);
    m_viewport->setScene(scene);
    m_viewport->picture();
    QCOMPARE(m_viewport->placements().at(0), methods::TexturePlacement{});
    QCOMPARE(m_viewport->placements().at(1), moved);
}

void ViewportGlTest::tellsFramesAndDrops() {
    QSignalSpy drawn(m_viewport.get(), &Viewport::frameDrawn);
    show(test::sceneOf(test::sphereMesh()));
    QTRY_VERIFY(drawn.count() > 0);
    QVERIFY(drawn.at(0).at(0).toDouble() > 0);

    QSignalSpy dropped(m_viewport.get(), &Viewport::filesDropped);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/paint/strip.png"), QUrl("https://example.org/x.png")});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_viewport.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_viewport.get(), &drop);
    QCOMPARE(dropped.count(), 1);
    QCOMPARE(dropped.at(0).at(0).toStringList(), QStringList{"/paint/strip.png"});
}

}  // namespace chiaro::widgets

QTEST_MAIN(chiaro::widgets::ViewportGlTest)
#include "viewport_gl_test.moc"
