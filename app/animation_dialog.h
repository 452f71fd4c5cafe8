#pragma once

#include "app/animation_export.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace chiaro::app {

/// Asks for the size and the files of the frames that are rendered.
class AnimationDialog : public QDialog {
    Q_OBJECT

public:
    AnimationDialog(const project::Animation& animation, const AnimationSettings& suggestion,
                    QWidget* parent);

    AnimationSettings settings() const;

    void accept() override;

private:
    void browse();
    void showOutput();

    project::Animation m_animation;
    AnimationSettings m_suggestion;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QCheckBox* m_transparent = nullptr;
    QCheckBox* m_withValues = nullptr;
    QCheckBox* m_resume = nullptr;
    QLineEdit* m_path = nullptr;
    QLabel* m_problem = nullptr;
    QPushButton* m_render = nullptr;
};

}  // namespace chiaro::app
