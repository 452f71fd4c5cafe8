#pragma once

#include "core/base/parameters.h"

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace chiaro::widgets {

/// A form built from a parameter table: a row a parameter with label, editor and a button back to its
/// default.
///
/// It shows what setValues() was given last and changes nothing by itself: whoever owns the values hears
/// valueEdited() and sets them again.
class ParameterForm : public QWidget {
    Q_OBJECT

public:
    /// One default a spec.
    ParameterForm(std::vector<ParameterSpec> specs, std::vector<double> defaults, QWidget* parent = nullptr);

    /// One value a spec; emits nothing.
    void setValues(std::span<const double> values);
    const std::vector<double>& values() const { return m_values; }

Q_SIGNALS:
    /// A new value within the spec's range; many in a row while a slider is dragged.
    void valueEdited(int index, double value);
    /// What was edited since the last time is one step for the artist.
    void editFinished();

private:
    using Show = std::function<void(double)>;

    void addRow(QGridLayout& grid, int index);
    QWidget* makeNumber(int index);
    QWidget* makeSwitch(int index);
    QWidget* makeChoice(int index);
    void edit(int index, double value);
    void showValue(int index, double value);
    QString tooltip(int index) const;

    std::vector<ParameterSpec> m_specs;
    std::vector<double> m_defaults;
    std::vector<double> m_values;
    std::vector<Show> m_show;            ///< puts a value into a row's editors without emitting
    std::vector<QToolButton*> m_resets;  ///< shown where the value is not the default
};

/// The form of a parameter struct that has a static table().
template <class Params>
ParameterForm* makeParameterForm(QWidget* parent = nullptr) {
    return new ParameterForm(Params::table().specs(), Params::table().values(Params{}), parent);
}

}  // namespace chiaro::widgets
