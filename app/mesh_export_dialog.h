#pragma once

#include "app/mesh_export.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace chiaro::widgets {
class ParameterForm;
}

namespace chiaro::app {

/// Asks how a painted mesh is to be written, and before it replaces a file.
class MeshExportDialog : public QDialog {
    Q_OBJECT

public:
    MeshExportDialog(const MeshSettings& suggestion, QWidget* parent);

    MeshSettings settings() const;
    void accept() override;

private:
    void browse();
    void setFormat(int format);
    void showFile();
    widgets::ParameterForm* makeForm(const std::vector<int>& indices);

    MeshSettings m_settings;
    QComboBox* m_format = nullptr;
    QLabel* m_note = nullptr;
    QLineEdit* m_path = nullptr;
    widgets::ParameterForm* m_texture = nullptr;  ///< of files that have one
    QPushButton* m_export = nullptr;
};

}  // namespace chiaro::app
