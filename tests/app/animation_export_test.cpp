#include "app/animation_export.h"

#include "app/animation_dialog.h"
#include "core/base/error.h"
#include "core/base/image_io.h"
#include "tests/app/app_support.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using test::Studio;

class AnimationExportTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    /// A turning tetrahedron of which frames 3 to 5 are rendered.
    bool prepare(Studio& studio) {
        if (!studio.open({test::writeStrip(m_folder / "oil.png"),
                          test::writeTetrahedron(m_folder / "head.obj", "head")}))
            return false;
        project::Animation animation;
        animation.path = scene::Path::turntable(12);
        animation.firstFrame = 3;
        animation.lastFrame = 5;
        studio.document.editAnimation(animation, "test");
        return true;
    }
    app::AnimationSettings settings(const char* name) {
        app::AnimationSettings settings;
        settings.output = m_folder / name;
        settings.width = 64;
        settings.height = 48;
        return settings;
    }

private Q_SLOTS:
    void theRenderRangeBecomesPictures() {
        Studio studio;
        QVERIFY(prepare(studio));
        app::exportAnimation(studio.document.project(), studio.meshes.scene(), settings("a.####.png"), {});
        std::vector<std::vector<float>> frames;
        for (const char* name : {"a.0003.png", "a.0004.png", "a.0005.png"}) {
            const DecodedImage picture = readImage(m_folder / name, {});
            QCOMPARE(picture.width, 64);
            QCOMPARE(picture.channels, 3);
            frames.push_back(picture.values);
        }
        QVERIFY(frames[0] != frames[1] && frames[1] != frames[2]);
        QVERIFY(!std::filesystem::exists(m_folder / "a.0002.png"));
        QVERIFY(!std::filesystem::exists(m_folder / "a.0006.png"));
    }

    void cancellingLeavesNoVideo() {
        Studio studio;
        QVERIFY(prepare(studio));
        std::stop_source stop;
        const Task task(stop.get_token(), [&](double fraction) {
            if (fraction > 0.5) stop.request_stop();
        });
        QVERIFY_EXCEPTION_THROWN(
            app::exportAnimation(studio.document.project(), studio.meshes.scene(), settings("a.mkv"), task),
            Cancelled);
        QVERIFY(!std::filesystem::exists(m_folder / "a.mkv"));
        app::exportAnimation(studio.document.project(), studio.meshes.scene(), settings("a.mkv"), {});
        QVERIFY(std::filesystem::file_size(m_folder / "a.mkv") > 100);
    }

    void withoutPaintItSaysWhatIsMissing() {
        QVERIFY_EXCEPTION_THROWN(app::exportAnimation({}, {}, settings("b.####.png"), {}), Error);
    }

    void theDialogRefusesWhatCannotBeWritten() {
        app::AnimationDialog dialog({}, settings("a.####.png"), nullptr);
        auto* output = dialog.findChild<QLineEdit*>("output");
        auto* problem = dialog.findChild<QLabel*>("problem");
        QPushButton* render = nullptr;
        for (QPushButton* button : dialog.findChildren<QPushButton*>())
            if (button->text() == "Render") render = button;
        QVERIFY(render && render->isEnabled());
        output->setText("/pictures/a.png");
        QVERIFY(!render->isEnabled() && problem->text().contains("#"));
        output->setText("/pictures/a.mp4");
        QVERIFY(render->isEnabled());
        QCOMPARE(dialog.settings().output, std::filesystem::path("/pictures/a.mp4"));
    }
};

QTEST_MAIN(AnimationExportTest)
#include "animation_export_test.moc"
