#pragma once

#include "widgets/viewport/composition.h"

#include <QWidget>

class QDoubleSpinBox;
class QSlider;
class QSpinBox;

namespace chiaro::widgets {

/// The numbers of how methods are compared, those of the mode that is on: how many panes, where a wipe's line
/// is, how much of the second a blend shows, what a difference is multiplied with.
class CompareBar : public QWidget {
    Q_OBJECT

public:
    explicit CompareBar(QWidget* parent = nullptr);

    /// `size` is that of the picture that is wiped.
    void setComposition(const Composition& composition, QSizeF size);

Q_SIGNALS:
    void compositionEdited(const chiaro::widgets::Composition& composition);
    void paneCountEdited(int count);

private:
    QDoubleSpinBox* addNumber(const char* name, const QString& label, const QString& tooltip,
                              Composition::Mode mode);
    void add(QWidget* widget, Composition::Mode mode);
    void edit(const Composition& composition);

    Composition m_composition;
    QSizeF m_size{1, 1};
    std::vector<std::pair<QWidget*, Composition::Mode>> m_fields;  ///< seen while the mode is on
    QSpinBox* m_panes = nullptr;
    QDoubleSpinBox* m_position = nullptr;
    QDoubleSpinBox* m_angle = nullptr;
    QSlider* m_blendSlider = nullptr;
    QDoubleSpinBox* m_blend = nullptr;
    QDoubleSpinBox* m_gain = nullptr;
};

}  // namespace chiaro::widgets
