#pragma once

#include "core/gradient/gradient.h"

#include <QWidget>

class QDoubleSpinBox;
class QToolButton;

namespace chiaro::widgets {

class ParameterForm;
class SpeedCurvePlot;

/// How a strip's gradient is found (§3.1): search scale, match speed, and the speed curve drawn by hand.
///
/// While the speed is matched the plot shows the matched curve; the first change to it turns matching off and
/// goes on from there.
class GradientCurveEditor : public QWidget {
    Q_OBJECT

public:
    explicit GradientCurveEditor(QWidget* parent = nullptr);

    void setParams(const gradient::GradientParams& params);
    /// What separating the strip gave last; null empties the editor.
    void setSeparation(const gradient::Separation* separation);
    SpeedCurvePlot* plot() const { return m_plot; }

Q_SIGNALS:
    void paramsEdited(const chiaro::gradient::GradientParams& params);
    void editFinished();

private:
    void edit(const gradient::GradientParams& params);
    void editCurve(const gradient::SpeedCurve& curve);
    void showParams();
    void showPoint();

    gradient::GradientParams m_params;
    gradient::SpeedCurve m_matched;
    ParameterForm* m_form = nullptr;
    SpeedCurvePlot* m_plot = nullptr;
    QDoubleSpinBox* m_x = nullptr;
    QDoubleSpinBox* m_y = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_straighten = nullptr;
};

}  // namespace chiaro::widgets
