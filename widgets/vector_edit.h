#pragma once

#include <glm/glm.hpp>

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QToolButton;

namespace chiaro::widgets {

/// Three numbers with their axes, and a button back to the standard ones.
///
/// It shows what setValue() was given last and changes nothing by itself: whoever owns the vector hears
/// valueEdited() and sets it again.
class VectorEdit : public QWidget {
    Q_OBJECT

public:
    struct Spec {
        QString key;        ///< the fields' object names are key-x, key-y, key-z
        QString name;       ///< for screen readers: "Position"
        QString unit = {};  ///< "°"; empty for a plain number
        double minimum = -1e6;
        double maximum = 1e6;
        double step = 0.1;
        int decimals = 3;
        glm::vec3 standard{0};
        bool hasLink = false;  ///< a button that keeps the numbers in proportion
    };
    explicit VectorEdit(const Spec& spec, QWidget* parent = nullptr);

    /// Emits nothing.
    void setValue(glm::vec3 value);
    glm::vec3 value() const { return m_value; }
    /// How far an arrow or a notch of the wheel goes.
    void setStep(double step);

Q_SIGNALS:
    void valueEdited(glm::vec3 value);
    /// What was edited since the last time is one step for the artist.
    void editFinished();

private:
    void edit(int axis, double value);

    Spec m_spec;
    glm::vec3 m_value{0};
    std::array<QDoubleSpinBox*, 3> m_fields{};
    QToolButton* m_link = nullptr;
    QToolButton* m_reset = nullptr;
};

}  // namespace chiaro::widgets
