#pragma once

#include "core/gradient/gradient.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QColorDialog;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace chiaro::widgets {

class ColorPathBar;
class Eyedropper;

/// The colours that a sample shows: its own, or a path of the artist's stops with the gestures of Blender's
/// colour ramp (§3.2, recolouring), or one of the presets.
class ColorPathView : public QWidget {
    Q_OBJECT

public:
    explicit ColorPathView(QWidget* parent = nullptr);

    /// Without a path the sample keeps its own colours.
    void setRecoloring(const std::optional<gradient::ColorPath>& path);
    /// The sample's own gradient, shown while nothing recolours it and the start of a new path; empty
    /// disables the view.
    void setOwnColors(const gradient::Gradient& colors);
    /// Before another sample is shown: nothing that was chosen for the last one is kept.
    void startAfresh();
    ColorPathBar* bar() const { return m_bar; }
    Eyedropper* eyedropper() const { return m_eyedropper; }
    /// One more button in the row of those that act on the whole path.
    void addTool(QWidget* tool);
    /// What is shown: the artist's path, else one close to the sample's own colours.
    gradient::ColorPath shownPath() const;

public Q_SLOTS:
    void flip();
    void distribute();
    /// The stops as text, such as "0 #201040, 1 #fff0b0".
    void copy() const;
    /// Shows the stops that the clipboard's text tells, or says what is wrong with it.
    void paste();

Q_SIGNALS:
    void recoloringEdited(const std::optional<chiaro::gradient::ColorPath>& path);
    void editFinished();

private:
    QWidget* makeHeader();
    QWidget* makePresets();
    QWidget* makeTools();
    void edit(const std::optional<gradient::ColorPath>& path);
    void editOnce(const std::optional<gradient::ColorPath>& path);
    void chooseColor();
    void showPatch(glm::vec3 color);
    void say(const QString& note);
    void showPath();
    void showStop();

    std::optional<gradient::ColorPath> m_path;
    gradient::ColorPath m_last;  ///< what switching the recolouring on again brings back
    gradient::Gradient m_own;
    QCheckBox* m_recolor = nullptr;
    ColorPathBar* m_bar = nullptr;
    QHBoxLayout* m_header = nullptr;
    QLabel* m_note = nullptr;  ///< what was wrong with the last paste
    QWidget* m_tools = nullptr;
    Eyedropper* m_eyedropper = nullptr;
    QToolButton* m_color = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_distribute = nullptr;
    QDoubleSpinBox* m_position = nullptr;
    QComboBox* m_space = nullptr;
};

}  // namespace chiaro::widgets
