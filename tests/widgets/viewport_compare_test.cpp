#include "tests/widgets/viewport_support.h"
#include "widgets/compare_bar.h"
#include "widgets/compare_view.h"

#include <QtTest>
#include <QtWidgets>

namespace chiaro::widgets {

namespace {

using Mode = Composition::Mode;
using Handle = CompareView::Handle;

const std::vector<std::string> threeMethods{"image-based", "view-aligned", "view-dependent"};

Composition composition(Mode mode, std::size_t count = 2) {
    Composition made;
    made.mode = mode;
    made.methods.assign(threeMethods.begin(), threeMethods.begin() + std::ptrdiff_t(count));
    made.wipeCenter = {0.45, 0.55};
    made.wipeAngle = 30;
    made.blend = 0.3;
    made.gain = 3;
    return made;
}

/// The largest difference of a channel, over all but `spared` of the pixels.
int largestDifference(const QImage& a, const QImage& b, std::size_t spared = 0) {
    std::vector<int> differences;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), other = b.pixel(x, y);
            differences.push_back(
                std::max({std::abs(qRed(one) - qRed(other)), std::abs(qGreen(one) - qGreen(other)),
                          std::abs(qBlue(one) - qBlue(other))}));
        }
    std::ranges::sort(differences, std::greater());
    return differences[spared];
}

QImage renderedByCore(const ViewSnapshot& view) {
    const scene::RayScene rays(view.scene);
    const scene::GBuffer gbuffer = scene::castGBuffer(rays.with(view.scene.occlusion), view.scene.lights,
                                                      view.camera, view.pixels.width(), view.pixels.height());
    return test::toQImage(methods::over(shaded(view, gbuffer, 1, {}).picture, view.background));
}

}  // namespace

/// Several methods in one viewport, by OpenGL where there is one, and by the CPU, which shows scenes with
/// shadows.
class ViewportCompareTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup() { m_viewport.reset(); }
    void picturesAreComposed_data();
    void picturesAreComposed();
    void panesShowEachMethodsPicture_data();
    void panesShowEachMethodsPicture();
    void aDragInAnyPaneMovesAll();
    void aLightDragReshadesAll();
    void theWheelZoomsAroundThePointerInItsPane();
    void everyMethodsFrameIsTimed();
    void lyingTogetherOtherwiseChangesNoPicture();
    void theLineIsDragged();
    void theLineIsTurned();
    void besideTheLineTheCameraTurns();
    void theLineObeysTheKeyboard();
    void labelsNameTheirMethods();
    void labelsStayInTheirPanes();
    void theBarEditsWhatItsModeHas();

private:
    void show(bool byCpu);
    QImage single(const std::string& method);
    QImage half(const QImage& picture, bool second) const;
    void move(QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {});

    std::unique_ptr<Viewport> m_viewport;
    std::shared_ptr<const ViewTexture> m_texture;
    std::vector<std::shared_ptr<const methods::PaintedObject>> m_painted;
    scene::Scene m_scene;
};

void ViewportCompareTest::initTestCase() {
    m_scene = test::sceneOf(test::sphereMesh());
    views::ViewParams views;
    views.count = 4;
    views.size = 96;
    m_painted = {test::paintedObject(m_scene.objects[0].mesh, views)};
}

void ViewportCompareTest::init() {
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(400, 240);
    m_viewport->setBackground({0.1f, 0.2f, 0.3f});
    m_viewport->setPaint(0, {test::generatedLevels(), test::generatedGradient()});
    m_viewport->setPaintedObjects(m_painted);
}

void ViewportCompareTest::show(bool byCpu) {
    scene::Scene scene = m_scene;
    scene.occlusion.shadows = byCpu;
    m_viewport->setScene(scene);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    if (!byCpu && !m_viewport->usesOpenGl()) QSKIP("no OpenGL 4.1 here");
    if (!m_texture)
        m_texture = test::imageBasedPicture(m_scene, m_viewport->camera(), test::generatedGradient(),
                                            m_viewport->background(), m_viewport->pixels())
                        .texture;
    m_viewport->setViewTexture(m_texture);
    m_viewport->picture();
}

QImage ViewportCompareTest::single(const std::string& method) {
    m_viewport->setComposition({});
    m_viewport->setMethod(method);
    return m_viewport->picture();
}

QImage ViewportCompareTest::half(const QImage& picture, bool second) const {
    const double ratio = m_viewport->devicePixelRatioF();
    const QRectF rect = m_viewport->panes()[std::size_t(second)].rect;
    return picture.copy(QRectF(rect.topLeft() * ratio, rect.size() * ratio).toRect());
}

void ViewportCompareTest::move(QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    // QTest::mouseMove tells no buttons.
    QMouseEvent event(QEvent::MouseMove, to, m_viewport->mapToGlobal(to), Qt::NoButton, button, modifiers);
    QApplication::sendEvent(m_viewport.get(), &event);
}

void ViewportCompareTest::drag(QPointF from, QPointF to, Qt::MouseButton button,
                               Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(m_viewport.get(), button, modifiers, from.toPoint());
    for (int step = 1; step <= 4; ++step) move(from + (to - from) * step / 4, button, modifiers);
    QTest::mouseRelease(m_viewport.get(), button, modifiers, to.toPoint());
}

void ViewportCompareTest::picturesAreComposed_data() {
    QTest::addColumn<Mode>("mode");
    QTest::addColumn<bool>("byCpu");
    for (const bool byCpu : {false, true}) {
        const char* renderer = byCpu ? "CPU" : "OpenGL";
        QTest::addRow("wipe by %s", renderer) << Mode::Wipe << byCpu;
        QTest::addRow("blend by %s", renderer) << Mode::Blend << byCpu;
        QTest::addRow("difference by %s", renderer) << Mode::Difference << byCpu;
    }
}

void ViewportCompareTest::picturesAreComposed() {
    QFETCH(Mode, mode);
    QFETCH(bool, byCpu);
    show(byCpu);
    const std::vector pictures{single(threeMethods[0]), single(threeMethods[1])};
    QVERIFY2(largestDifference(pictures[0], pictures[1]) > 20, "two methods that look alike tell nothing");
    const Composition wanted = composition(mode);
    m_viewport->setComposition(wanted);
    const QImage shown = m_viewport->picture();
    const QImage expected = composed(wanted, pictures, shown.size(), 1, Qt::black);
    test::keepPicture(shown, QString("compare_%1").arg(QTest::currentDataTag()));
    if (byCpu) {
        QCOMPARE(shown, expected);
        return;
    }
    // OpenGL rounds a blend's and a difference's channels by itself, so they may be a step apart; of a wipe a
    // pixel whose middle lies on the line itself may be either's.
    const std::size_t spared = mode == Mode::Wipe ? 2 : 0;
    QVERIFY2(largestDifference(shown, expected, spared) <= (mode == Mode::Wipe ? 0 : 1),
             qPrintable(QString::number(largestDifference(shown, expected, spared))));
}

void ViewportCompareTest::panesShowEachMethodsPicture_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("byCpu");
    for (const int count : {2, 3})
        for (const bool byCpu : {false, true})
            QTest::addRow("%d by %s", count, byCpu ? "CPU" : "OpenGL") << count << byCpu;
}

void ViewportCompareTest::panesShowEachMethodsPicture() {
    QFETCH(int, count);
    QFETCH(bool, byCpu);
    show(byCpu);
    m_viewport->setComposition(composition(Mode::SideBySide, std::size_t(count)));
    const QImage shown = m_viewport->picture();
    QCOMPARE(shown.size(), m_viewport->size() * m_viewport->devicePixelRatioF());
    test::keepPicture(shown, QString("compare_panes_%1").arg(QTest::currentDataTag()));
    const std::vector<ViewSnapshot> snapshots = m_viewport->snapshots();
    QCOMPARE(int(snapshots.size()), count);
    const auto panes = paneRects(composition(Mode::SideBySide, std::size_t(count)), shown.size(),
                                 m_viewport->devicePixelRatioF());
    for (std::size_t i = 0; i < panes.size(); ++i) {
        QCOMPARE(snapshots[i].method, threeMethods[i]);
        const QImage pane = shown.copy(panes[i]), expected = renderedByCore(snapshots[i]);
        if (byCpu)
            QCOMPARE(pane, expected);
        else  // edges have more samples there
            QVERIFY2(test::meanDifference(pane, expected) < 1.5,
                     qPrintable(QString::number(test::meanDifference(pane, expected))));
    }
}

void ViewportCompareTest::aDragInAnyPaneMovesAll() {
    show(false);
    m_viewport->setComposition(composition(Mode::SideBySide));
    const QImage before = m_viewport->picture();
    const scene::Camera start = m_viewport->camera();
    QSignalSpy edited(m_viewport.get(), &Viewport::cameraEdited);
    drag({300, 120}, {330, 130});
    const scene::Camera right = m_viewport->camera();
    QCOMPARE(edited.count(), 4);
    QVERIFY(right.azimuth != start.azimuth);
    const QImage after = m_viewport->picture();
    QVERIFY(test::meanDifference(half(before, false), half(after, false)) > 1);
    QVERIFY(test::meanDifference(half(before, true), half(after, true)) > 1);
    // The same drag in the other pane does the same.
    m_viewport->setCamera(start);
    drag({100, 120}, {130, 130});
    QCOMPARE(m_viewport->camera(), right);
    // Panning follows the mouse in a pane's own size.
    m_viewport->setCamera(start);
    drag({300, 120}, {310, 120}, Qt::MiddleButton, Qt::ShiftModifier);
    const scene::Camera panned = m_viewport->camera();
    QCOMPARE(panned, widgets::panned(start, {10, 0}, m_viewport->panes()[0].rect.size()));
}

void ViewportCompareTest::aLightDragReshadesAll() {
    show(false);
    m_viewport->setComposition(composition(Mode::SideBySide));
    const QImage before = m_viewport->picture();
    QSignalSpy finished(m_viewport.get(), &Viewport::lightEditFinished);
    drag({300, 120}, {380, 120}, Qt::RightButton, Qt::ShiftModifier);
    QCOMPARE(finished.count(), 1);
    const QImage after = m_viewport->picture();
    QVERIFY(test::meanDifference(half(before, false), half(after, false)) > 1);
    QVERIFY(test::meanDifference(half(before, true), half(after, true)) > 1);
}

void ViewportCompareTest::theWheelZoomsAroundThePointerInItsPane() {
    show(false);
    m_viewport->setComposition(composition(Mode::SideBySide));
    const scene::Camera start = m_viewport->camera();
    const QRectF pane = m_viewport->panes()[1].rect;
    const QPointF at = pane.topLeft() + QPointF(30, 40);
    QWheelEvent wheel(at, m_viewport->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(m_viewport.get(), &wheel);
    QCOMPARE(m_viewport->camera(), zoomed(start, wheelZoomFactor(120), {30, 40}, pane.size()));
}

void ViewportCompareTest::everyMethodsFrameIsTimed() {
    show(false);
    m_viewport->setComposition(composition(Mode::SideBySide, 3));
    m_viewport->picture();
    QCOMPARE(m_viewport->methodTimes().size(), 3U);
    QVERIFY(std::ranges::all_of(m_viewport->methodTimes(), [](double time) { return time > 0; }));
}

void ViewportCompareTest::lyingTogetherOtherwiseChangesNoPicture() {
    show(false);
    Composition wipe = composition(Mode::Wipe);
    m_viewport->setComposition(wipe);
    QSignalSpy pictures(m_viewport.get(), &Viewport::pictureChanged);
    QSignalSpy panes(m_viewport.get(), &Viewport::panesChanged);
    QSignalSpy views(m_viewport.get(), &Viewport::viewChanged);
    wipe.wipeCenter.x = 0.7;
    m_viewport->setComposition(wipe);
    wipe.mode = Mode::Blend;
    m_viewport->setComposition(wipe);
    QCOMPARE(pictures.count(), 0);
    QCOMPARE(panes.count(), 2);
    m_viewport->setComposition(composition(Mode::SideBySide));
    QCOMPARE(pictures.count(), 1);
    QCOMPARE(views.count(), 1);
    m_viewport->setMethod("view-dependent");  // which isn't shown
    QCOMPARE(pictures.count(), 1);
}

void ViewportCompareTest::theLineIsDragged() {
    show(false);
    CompareView& view = *new CompareView(*m_viewport, {});
    Composition wipe = composition(Mode::Wipe);
    wipe.wipeCenter = {0.5, 0.5};
    wipe.wipeAngle = 0;
    view.setComposition(wipe);
    m_viewport->setComposition(wipe);
    QSignalSpy edited(&view, &CompareView::compositionEdited);
    connect(&view, &CompareView::compositionEdited, m_viewport.get(), &Viewport::setComposition);
    const scene::Camera camera = m_viewport->camera();
    QCOMPARE(view.handleAt({203, 20}), Handle::Line);
    QCOMPARE(view.handleAt({230, 20}), Handle::None);
    const QImage before = m_viewport->picture();
    drag({202, 225}, {302, 225});
    QCOMPARE(edited.count(), 4);
    const auto moved = edited.last().at(0).value<Composition>();
    QCOMPARE(moved.wipeCenter.x, 0.75);
    QCOMPARE(moved.wipeAngle, 0.0);
    QCOMPARE(m_viewport->camera(), camera);
    QVERIFY(m_viewport->picture() != before);
    // It stays in the picture.
    drag(view.handlePosition(Handle::Line), {2000, 120});
    QCOMPARE(edited.last().at(0).value<Composition>().wipeCenter.x, 1.0);
}

void ViewportCompareTest::theLineIsTurned() {
    show(false);
    CompareView& view = *new CompareView(*m_viewport, {});
    Composition wipe = composition(Mode::Wipe);
    wipe.wipeCenter = {0.5, 0.5};
    wipe.wipeAngle = 0;
    view.setComposition(wipe);
    m_viewport->setComposition(wipe);
    QSignalSpy edited(&view, &CompareView::compositionEdited);
    const QPointF middle = view.handlePosition(Handle::Line);
    // The lower end goes left: a quarter turn clockwise.
    QCOMPARE(view.handleAt(view.handlePosition(Handle::End)), Handle::End);
    QVERIFY(view.handlePosition(Handle::End).y() > middle.y());
    drag(view.handlePosition(Handle::End), middle - QPointF(80, 0));
    auto turned = edited.last().at(0).value<Composition>();
    QVERIFY(std::abs(turned.wipeAngle - 90) < 1e-6);
    QVERIFY(turned.wipeCenter == glm::dvec2(0.5));
    // Its other end, with Shift in steps.
    drag(view.handlePosition(Handle::Start), middle + QPointF(60, -57), Qt::LeftButton, Qt::ShiftModifier);
    turned = edited.last().at(0).value<Composition>();
    QVERIFY2(std::abs(turned.wipeAngle - 45) < 1e-6, qPrintable(QString::number(turned.wipeAngle)));
}

void ViewportCompareTest::besideTheLineTheCameraTurns() {
    show(false);
    CompareView& view = *new CompareView(*m_viewport, {});
    view.setComposition(composition(Mode::Wipe));
    m_viewport->setComposition(composition(Mode::Wipe));
    const scene::Camera before = m_viewport->camera();
    QSignalSpy edited(&view, &CompareView::compositionEdited);
    drag({20, 20}, {60, 20});
    QCOMPARE(edited.count(), 0);
    QVERIFY(m_viewport->camera() != before);
    // And where nothing is wiped the line takes nothing.
    view.setComposition(composition(Mode::Blend));
    QCOMPARE(view.handleAt(view.handlePosition(Handle::Line)), Handle::None);
}

void ViewportCompareTest::theLineObeysTheKeyboard() {
    show(false);
    CompareView& view = *new CompareView(*m_viewport, {});
    Composition wipe = composition(Mode::Wipe);
    wipe.wipeCenter = {0.5, 0.5};
    wipe.wipeAngle = 0;
    view.setComposition(wipe);
    QVERIFY(view.focusPolicy() & Qt::TabFocus);
    QVERIFY(!view.accessibleName().isEmpty() && view.accessibleDescription().contains("50 %"));
    const auto after = [&](Qt::Key key) {
        QSignalSpy edited(&view, &CompareView::compositionEdited);
        QTest::keyClick(&view, key);
        return edited.isEmpty() ? Composition{} : edited.last().at(0).value<Composition>();
    };
    QVERIFY(after(Qt::Key_Right).wipeCenter.x > 0.5);
    QVERIFY(after(Qt::Key_Down).wipeCenter.y > 0.5);
    QCOMPARE(after(Qt::Key_PageDown).wipeAngle, 5.0);
    QCOMPARE(after(Qt::Key_PageUp).wipeAngle, 0.0);
    QVERIFY(after(Qt::Key_Home).wipeCenter == glm::dvec2(0.5));
    view.setComposition(composition(Mode::Difference));
    QCOMPARE(view.focusPolicy(), Qt::NoFocus);
}

void ViewportCompareTest::labelsNameTheirMethods() {
    show(false);
    CompareView& view =
        *new CompareView(*m_viewport, {{threeMethods[0], "Image"}, {threeMethods[1], "Aligned"}});
    view.setComposition(composition(Mode::SideBySide));
    m_viewport->setComposition(composition(Mode::SideBySide));
    view.setFigures(1, {"4.2 ms", "similarity 0.08"});
    QCOMPARE(view.label(0).text(), QString("Image"));
    QCOMPARE(view.label(1).text(), QString("Aligned · 4.2 ms · similarity 0.08"));
    QVERIFY(view.label(0).isVisible() && view.label(1).isVisible() && !view.label(2).isVisible());
    auto* button = view.label(1).findChild<QToolButton*>();
    QCOMPARE(button->accessibleName(), QString("Second picture: Aligned"));
    QVERIFY(button->focusPolicy() & Qt::TabFocus);
    QSignalSpy chosen(&view, &CompareView::methodChosen);
    button->menu()->actions().front()->trigger();
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toInt(), 1);
    QCOMPARE(chosen[0][1].toString(), QString("image-based"));
    view.setComposition({});
    m_viewport->setComposition({});
    QVERIFY(!view.label(0).isVisible());
}

void ViewportCompareTest::labelsStayInTheirPanes() {
    show(false);
    CompareView& view = *new CompareView(
        *m_viewport,
        {{threeMethods[0], "Image-based"}, {threeMethods[1], "View-aligned"}, {threeMethods[2], "x"}});
    for (const QSize size : {QSize(400, 240), QSize(900, 500), QSize(300, 500)}) {
        m_viewport->resize(size);
        for (const Mode mode : {Mode::SideBySide, Mode::Wipe, Mode::Blend, Mode::Difference})
            for (const double angle : {0.0, 90.0, 180.0, -90.0}) {
                Composition shown = composition(mode, mode == Mode::SideBySide ? 3 : 2);
                shown.wipeAngle = angle;
                shown.wipeCenter = {0.5, 0.5};
                m_viewport->setComposition(shown);
                view.setComposition(shown);
                const auto panes = m_viewport->panes();
                for (std::size_t i = 0; i < panes.size(); ++i) {
                    view.setFigures(i, {"12.3 ms", "similarity 0.081", "shading 0.104"});
                    const QRect place = view.label(i).geometry();
                    const QRectF pane = mode == Mode::SideBySide ? panes[i].rect : QRectF(m_viewport->rect());
                    QVERIFY(pane.contains(QRectF(place)));
                    if (mode == Mode::Wipe && size.width() >= 900)
                        QVERIFY(panes[i].seen.containsPoint(QRectF(place).center(), Qt::OddEvenFill));
                    for (std::size_t other = 0; other < i; ++other)
                        QVERIFY(!view.label(other).geometry().intersects(place));
                }
            }
    }
}

void ViewportCompareTest::theBarEditsWhatItsModeHas() {
    CompareBar bar;
    bar.show();
    const auto field = [&](const char* name) { return bar.findChild<QWidget*>(name); };
    const auto shown = [&] {
        QStringList names;
        for (const char* name :
             {"compare-panes", "wipe-position", "wipe-angle", "blend-amount", "difference-gain"})
            if (field(name)->isVisibleTo(&bar)) names << name;
        return names;
    };
    QSignalSpy edited(&bar, &CompareBar::compositionEdited);
    const auto last = [&] { return edited.last().at(0).value<Composition>(); };
    bar.setComposition(composition(Mode::Wipe), {400, 200});
    QCOMPARE(shown(), (QStringList{"wipe-position", "wipe-angle"}));
    auto* position = static_cast<QDoubleSpinBox*>(field("wipe-position"));
    position->setFocus();
    QTest::keyClick(position, Qt::Key_Up);
    QCOMPARE(edited.count(), 1);
    QVERIFY(wipePosition(last(), {400, 200}) > wipePosition(composition(Mode::Wipe), {400, 200}));
    QTest::keyClick(field("wipe-angle"), Qt::Key_Up);
    QCOMPARE(last().wipeAngle, 35.0);
    bar.setComposition(composition(Mode::Blend), {400, 200});
    QCOMPARE(shown(), QStringList{"blend-amount"});
    QTest::keyClick(field("blend-slider"), Qt::Key_End);
    QCOMPARE(last().blend, 1.0);
    bar.setComposition(composition(Mode::Difference), {400, 200});
    QCOMPARE(shown(), QStringList{"difference-gain"});
    QTest::keyClick(field("difference-gain"), Qt::Key_Up);
    QCOMPARE(last().gain, 4.0);
    bar.setComposition(composition(Mode::SideBySide), {400, 200});
    QCOMPARE(shown(), QStringList{"compare-panes"});
    QSignalSpy counted(&bar, &CompareBar::paneCountEdited);
    QTest::keyClick(field("compare-panes"), Qt::Key_Up);
    QCOMPARE(counted.count(), 1);
    QCOMPARE(counted[0][0].toInt(), 3);
    for (QWidget* one : bar.findChildren<QWidget*>())
        if (one->focusPolicy() & Qt::TabFocus && !one->objectName().isEmpty() &&
            !one->objectName().startsWith("qt_"))
            QVERIFY2(!one->accessibleName().isEmpty() && !one->toolTip().isEmpty(),
                     qPrintable(one->objectName()));
}

}  // namespace chiaro::widgets

QTEST_MAIN(chiaro::widgets::ViewportCompareTest)
#include "viewport_compare_test.moc"
