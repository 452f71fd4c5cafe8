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

    void valuesGoBesideAndFinishedFramesStay() {
        Studio studio;
        QVERIFY(prepare(studio));
        app::AnimationSettings wanted = settings("v.####.exr");
        wanted.withValues = wanted.resume = true;
        const auto render = [&] {
            return app::exportAnimation(studio.document.project(), studio.meshes.scene(), wanted, {});
        };
        QCOMPARE(render(), 0);
        for (const char* name : {"light.0003.exr", "id.0003.png", "depth.0004.exr", "normal.0004.exr",
                                 "texture.0005.exr", "motion.0005.exr"})
            QVERIFY2(std::filesystem::exists(m_folder / "v values" / name), name);
        std::filesystem::remove(m_folder / "v.0004.exr");
        std::filesystem::remove(m_folder / "v values/depth.0005.exr");
        QCOMPARE(render(), 1);
        QVERIFY(std::filesystem::exists(m_folder / "v.0004.exr"));
        QVERIFY(std::filesystem::exists(m_folder / "v values/depth.0005.exr"));
        wanted.background = glm::vec3(1);  // other pictures
        QCOMPARE(render(), 0);
        // White of a display is 1 in a scene, a mid grey less than half of it.
        wanted.background = glm::vec3(0.5f);
        QCOMPARE(render(), 0);
        QVERIFY(std::abs(readImage(m_folder / "v.0003.exr", {}).values.front() - 0.214f) < 0.001f);
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
        for (const char* name : {"values", "resume"}) {
            dialog.findChild<QCheckBox*>(name)->setChecked(true);
            QVERIFY(!dialog.findChild<QCheckBox*>(name)->isEnabled());
        }
        QVERIFY(!dialog.settings().resume && !dialog.settings().withValues);  // videos have neither
        output->setText("/pictures/a.####.png");
        QVERIFY(dialog.settings().resume && dialog.settings().withValues);
    }
};

QTEST_MAIN(AnimationExportTest)
#include "animation_export_test.moc"
