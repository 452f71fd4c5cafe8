#include "app/measured_view.h"

#include "core/base/error.h"
#include "core/base/random.h"

#include <QtTest>

using namespace chiaro;

namespace {

constexpr int width = 96, height = 40;

/// Brush marks, dark on the left, light on the right.
ColorImage strip(std::uint64_t seed) {
    Random random(seed);
    ColorImage picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture(x, y) = glm::vec3(0.1F + 0.7F * float(x) / (width - 1)) + 0.2F * float(random.uniform());
    return picture;
}

app::MeasuredStrip worn(const ColorImage& source, std::vector<bool> wears) {
    return {std::make_shared<const metrics::NeighbourIndex>(source), std::move(wears)};
}

/// The strip itself, lit as it was painted, all of it object 1.
app::MeasuredView itself(const ColorImage& source) {
    app::MeasuredView view{source, IdImage(width, height, 1), ScalarImage(width, height)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) view.light(x, y) = float(x) / (width - 1);
    return view;
}

}  // namespace

class MeasuredViewTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aPictureThatIsTheStripHasNoError() {
        const ColorImage source = strip(1);
        const std::vector strips{worn(source, {false, true})};
        metrics::MeasureParams params;
        params.neighbours = 1;
        const app::ViewMatches found = app::measureView(itself(source), strips, params);
        QCOMPARE(found.pixels.size(), 100U);
        QCOMPARE(found.measure.similarity.mean, 0.0);
        QVERIFY(found.measure.shadingAbsolute->mean < 1e-6);
        for (std::size_t i = 0; i < found.pixels.size(); ++i)
            QVERIFY(glm::ivec2(found.matches[i].best) == found.pixels[i]);
    }

    void everyObjectIsComparedWithItsOwnStrip() {
        const ColorImage first = strip(1), second = strip(2);
        app::MeasuredView view = itself(first);
        for (int y = 0; y < height; ++y)
            for (int x = width / 2; x < width; ++x) {
                view.picture(x, y) = second(x, y);
                // Edges are found across borders, so some pixels lie between the objects.
                view.objects(x, y) = x < width / 2 + 4 ? 0 : 2;
            }
        for (int y = 0; y < height; ++y)
            for (int x = width / 2 - 4; x < width / 2; ++x) view.objects(x, y) = 0;
        metrics::MeasureParams params;
        params.neighbours = 1;
        const std::vector right{worn(first, {false, true, false}), worn(second, {false, false, true})};
        QCOMPARE(app::measureView(view, right, params).measure.similarity.mean, 0.0);
        const std::vector swapped{worn(second, {false, true, false}), worn(first, {false, false, true})};
        QVERIFY(app::measureView(view, swapped, params).measure.similarity.mean > 0.05);
    }

    void theMapOfEveryPixelIsCoresOwn() {
        const ColorImage source = strip(1);
        app::MeasuredView view = itself(strip(3));
        for (int y = 0; y < height; ++y) view.objects(0, y) = 0;
        const std::vector strips{worn(source, {false, true})};
        const app::ViewMaps maps = app::mapView(view, strips, 1, 3);
        metrics::MeasuredFrame frame;
        frame.picture = &view.picture;
        frame.objects = &view.objects;
        frame.light = &view.light;
        const metrics::FrameMaps expected = metrics::mapFrame(*strips[0].index, frame, 3);
        QVERIFY(maps.similarity == expected.similarity);
        QVERIFY(maps.shadingError == expected.shadingError);
        QVERIFY(maps.best == expected.best);
        QCOMPARE(maps.measure.similarity.mean, expected.measure.similarity.mean);
    }

    void aCoarseMapCoversWhatTheFineOneCovers() {
        const ColorImage source = strip(1);
        const app::MeasuredView view = itself(strip(3));
        const std::vector strips{worn(source, {false, true})};
        const app::ViewMaps coarse = app::mapView(view, strips, 4, 3),
                            fine = app::mapView(view, strips, 1, 3);
        int same = 0, measured = 0;
        for (int y = 8; y < height - 8; ++y)
            for (int x = 8; x < width - 8; ++x) {
                QVERIFY(coarse.similarity(x, y) >= 0);
                ++measured;
                same += coarse.similarity(x, y) == fine.similarity(x, y);
                QCOMPARE(coarse.similarity(x, y), fine.similarity(x / 4 * 4 + 2, y / 4 * 4 + 2));
            }
        QVERIFY(same >= measured / 16);
        QCOMPARE(coarse.similarity(0, 0), -1.0F);
    }

    void whatCantBeMeasuredIsSaidInASentence() {
        const ColorImage source = strip(1);
        app::MeasuredView view = itself(source);
        QVERIFY_EXCEPTION_THROWN(app::measureView(view, {}, {}), Error);
        const std::vector strips{worn(source, {false, false, true})};
        QVERIFY_EXCEPTION_THROWN(app::measureView(view, std::vector{worn(source, {false, false})}, {}),
                                 Error);
        view.objects = IdImage(width, height, 0);
        view.objects(5, 5) = 2;  // an object of one pixel holds no block
        QVERIFY_EXCEPTION_THROWN(app::measureView(view, strips, {}), Error);
        QVERIFY_EXCEPTION_THROWN(app::mapView(view, strips, 4, 3), Error);
    }

    void workIsCancelledAtOnce() {
        const ColorImage source = strip(1);
        std::stop_source stop;
        stop.request_stop();
        const std::vector strips{worn(source, {false, true})};
        QVERIFY_EXCEPTION_THROWN(app::mapView(itself(source), strips, 1, 3, Task(stop.get_token())),
                                 Cancelled);
    }
};

QTEST_APPLESS_MAIN(MeasuredViewTest)
#include "measured_view_test.moc"
