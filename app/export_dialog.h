#pragma once

#include "app/picture_export.h"

#include <QDialog>

class QCheckBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace chiaro::app {

/// Asks for a picture's size and file, and before it replaces a file.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(const PictureSettings& suggestion, QWidget* parent);

    PictureSettings settings() const;
    void accept() override;

private:
    void browse();
    void showFile();

    PictureSettings m_suggestion;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QCheckBox* m_transparent = nullptr;
    QCheckBox* m_keepsScale = nullptr;
    QLineEdit* m_path = nullptr;
    QPushButton* m_export = nullptr;
};

}  // namespace chiaro::app
