#pragma once

#include <QWidget>

class QLabel;

namespace chiaro::widgets {
class ParameterForm;
class VectorEdit;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class Meshes;

/// A light of the document: its kind, where it shines from, how much it gives.
class LightPanel : public QWidget {
    Q_OBJECT

public:
    LightPanel(Document& document, Meshes& meshes);

    void showLight(int light);

private:
    /// False once the light is removed: its fields may lose the focus, and tell of it, only then.
    bool isThere() const;
    void edit();

    Document& m_document;
    Meshes& m_meshes;
    QLabel* m_vectorLabel = nullptr;
    widgets::VectorEdit* m_vector = nullptr;
    widgets::ParameterForm* m_form = nullptr;
    int m_light = 0;
};

}  // namespace chiaro::app
