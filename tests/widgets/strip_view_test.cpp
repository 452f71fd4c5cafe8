#include "widgets/strip_view.h"

#include "widgets/picture.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::StripPictures;
using widgets::StripView;

namespace {

/// Grey from 0 to 1, with a texture of +-0.1 in alternating rows.
std::shared_ptr<const StripPictures> greyPictures() {
    auto pictures = std::make_shared<StripPictures>();
    pictures->strip = ColorImage(100, 20);
    pictures->texture = ColorImage(100, 20);
    for (int x = 0; x < 100; ++x) {
        pictures->averages.push_back(glm::vec3(float(x) / 99));
        for (int y = 0; y < 20; ++y) {
            pictures->texture(x, y) = glm::vec3(y % 2 == 0 ? 0.1F : -0.1F);
            pictures->strip(x, y) = pictures->averages.back() + pictures->texture(x, y);
        }
    }
    pictures->gradient = pictures->averages;
    return pictures;
}

int rowOf(const StripView& view, int number) {
    constexpr std::array middles{22, 58, 79, 115, 166};
    return view.isVisible() ? middles[std::size_t(number)] : -1;
}

}  // namespace

class StripViewTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyStageIsShownDarkToLight() {
        StripView view;
        view.resize(400, view.sizeHint().height());
        view.setPictures(greyPictures());
        view.setRecoloring({});
        view.show();
        (void)QTest::qWaitForWindowExposed(&view);
        const QImage picture = view.grab().toImage();
        const int light = picture.width() - 4;
        for (int row : {1, 2}) {
            QVERIFY(qGray(picture.pixel(light, rowOf(view, row))) > 240);
            QVERIFY(qGray(picture.pixel(light - 150, rowOf(view, row))) < 200);
        }
        // The texture lies on middle grey at both ends.
        QVERIFY(std::abs(qGray(picture.pixel(light, rowOf(view, 3))) - 128) < 40);
    }

    void recolouringChangesTheLastRowAlone() {
        StripView view;
        view.resize(400, view.sizeHint().height());
        view.setPictures(greyPictures());
        view.setRecoloring({});
        view.show();
        (void)QTest::qWaitForWindowExposed(&view);
        const QImage before = view.grab().toImage();
        view.setRecoloring({glm::vec3(0.5F, 0, 0), glm::vec3(0.5F, 0, 0)});
        const QImage after = view.grab().toImage();
        const int middle = before.width() / 2 + 40;
        for (int row = 0; row < 4; ++row)
            QCOMPARE(after.pixel(middle, rowOf(view, row)), before.pixel(middle, rowOf(view, row)));
        QVERIFY(qRed(after.pixel(middle, rowOf(view, 4))) > qBlue(after.pixel(middle, rowOf(view, 4))) + 60);
    }

    void anEmptyViewPaints() {
        StripView view;
        view.setRecoloring({glm::vec3(1)});
        view.setPictures(nullptr);
        QVERIFY(!view.grab().isNull());
    }

    void reducingAverages() {
        ColorImage checks(4, 4);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) checks(x, y) = glm::vec3((x + y) % 2 == 0 ? 1.0F : 0.0F);
        const ColorImage half = widgets::reduced(checks, 2, 2);
        QCOMPARE(half.width(), 2);
        for (const glm::vec3& pixel : half.pixels()) QCOMPARE(pixel, glm::vec3(0.5F));
        QVERIFY(widgets::reduced(checks, 4, 8) == checks);
    }

    void largeStripsAreReduced() {
        gradient::Separation separation;
        separation.texture = ColorImage(3000, 700, glm::vec3(0.25F));
        const StripPictures pictures = StripPictures::of(ColorImage(3000, 700, glm::vec3(0.5F)), separation);
        QVERIFY(pictures.strip.width() <= 1024 && pictures.strip.height() <= 192);
        QVERIFY(pictures.texture.width() == pictures.strip.width());
        QCOMPARE(pictures.texture(5, 5), glm::vec3(0.25F));
    }
};

QTEST_MAIN(StripViewTest)
#include "strip_view_test.moc"
