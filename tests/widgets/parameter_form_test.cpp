#include "widgets/parameter_form.h"

#include "core/synthesis/levels.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::ParameterForm;

namespace {

ParameterForm makeForm() {
    return ParameterForm(
        {ParameterSpec::integer("block", "Block", "px", 4, 256, "Side of a block"),
         ParameterSpec::real("density", "Density", "", 0.1, 10, 0.05, "Texture pixels per screen pixel"),
         ParameterSpec::boolean("zoom", "Follow zoom", "Scale the strokes with the object"),
         ParameterSpec::choice("tiling", "Tiling", {"mask", "seam"}, "How levels repeat"),
         ParameterSpec::integer("seed", "Seed", "", 0, 9007199254740992.0,
                                "Another number, another texture")},
        {32, 1, 1, 1, 1});
}

}  // namespace

class ParameterFormTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void settingValuesShowsThemAndEmitsNothing() {
        ParameterForm form = makeForm();
        QSignalSpy edited(&form, &ParameterForm::valueEdited);
        QSignalSpy finished(&form, &ParameterForm::editFinished);
        form.setValues(std::array{48.0, 2.5, 0.0, 0.0, 77.0});
        QCOMPARE(form.findChild<QDoubleSpinBox*>("block")->value(), 48.0);
        QCOMPARE(form.findChild<QDoubleSpinBox*>("density")->value(), 2.5);
        QVERIFY(!form.findChild<QCheckBox*>("zoom")->isChecked());
        QCOMPARE(form.findChild<QComboBox*>("tiling")->currentText(), "Mask");
        QCOMPARE(form.findChild<QDoubleSpinBox*>("seed")->value(), 77.0);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(finished.count(), 0);
    }

    void aTypedNumberIsOneEdit() {
        ParameterForm form = makeForm();
        QSignalSpy edited(&form, &ParameterForm::valueEdited);
        QSignalSpy finished(&form, &ParameterForm::editFinished);
        auto* field = form.findChild<QDoubleSpinBox*>("density");
        field->selectAll();
        QTest::keyClicks(field, "3.25");
        QCOMPARE(edited.count(), 0);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(edited.count(), 1);
        QCOMPARE(edited[0][0].toInt(), 1);
        QCOMPARE(edited[0][1].toDouble(), 3.25);
        QCOMPARE(finished.count(), 1);
        QCOMPARE(form.values()[1], 3.25);
    }

    void aSliderCoversTheRangeInSteps() {
        ParameterForm form = makeForm();
        auto* slider = form.findChild<QSlider*>("block-slider");
        slider->setValue(slider->maximum());
        QCOMPARE(form.values()[0], 256.0);
        slider->setValue(0);
        QCOMPARE(form.values()[0], 4.0);
        QCOMPARE(form.findChild<QDoubleSpinBox*>("block")->value(), 4.0);
    }

    void aSeedHasNoSlider() {
        ParameterForm form = makeForm();
        QVERIFY(form.findChild<QSlider*>("seed-slider") == nullptr);
    }

    void resetIsThereOnlyForChangedValues() {
        ParameterForm form = makeForm();
        auto* reset = form.findChild<QToolButton*>("block-reset");
        QVERIFY(reset->isHidden());
        form.setValues(std::array{64.0, 1.0, 1.0, 1.0, 1.0});
        QVERIFY(!reset->isHidden());
        QSignalSpy edited(&form, &ParameterForm::valueEdited);
        reset->click();
        QCOMPARE(edited.count(), 1);
        QCOMPARE(form.values()[0], 32.0);
        QVERIFY(reset->isHidden());
    }

    void tooltipsNameRangeAndDefault() {
        ParameterForm form = makeForm();
        const QString tooltip = form.findChild<QDoubleSpinBox*>("block")->parentWidget()->toolTip();
        QVERIFY2(tooltip.contains("4 to 256 px") && tooltip.contains("default 32"), qPrintable(tooltip));
    }

    void theWheelLeavesFieldsWithoutFocusAlone() {
        ParameterForm form = makeForm();
        auto* field = form.findChild<QDoubleSpinBox*>("block");
        QWheelEvent wheel({5, 5}, {5, 5}, {0, 0}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(field, &wheel);
        QCOMPARE(form.values()[0], 32.0);
    }

    void everyParameterOfTheLevelsGetsAnEditor() {
        const std::unique_ptr<ParameterForm> form(widgets::makeParameterForm<synthesis::LevelParams>());
        for (const ParameterSpec& spec : synthesis::LevelParams::table().specs())
            QVERIFY2(form->findChild<QWidget*>(QString::fromStdString(spec.key)) != nullptr,
                     spec.key.c_str());
    }
};

QTEST_MAIN(ParameterFormTest)
#include "parameter_form_test.moc"
