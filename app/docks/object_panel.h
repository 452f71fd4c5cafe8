#pragma once

#include "app/change.h"
#include "core/scene/placement.h"

#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;
class QGridLayout;

namespace chiaro::widgets {
class VectorEdit;
}

namespace chiaro::app {

class Document;
class Meshes;

/// How an object of the document stands in the scene, and the sample that it and those selected with it wear.
class ObjectPanel : public QWidget {
    Q_OBJECT

public:
    ObjectPanel(Document& document, Meshes& meshes);

    /// The object whose place is edited, and all that a sample is put on.
    void showObject(int object, std::vector<int> selected);

private:
    void applyChange(Change change);
    widgets::VectorEdit* addVector(QGridLayout& grid, const QString& label, widgets::VectorEdit* edit);
    void edit(const QString& text, const std::function<void(scene::Placement&)>& change);
    void dress(int sample);

    Document& m_document;
    Meshes& m_meshes;
    QComboBox* m_sample = nullptr;
    widgets::VectorEdit* m_position = nullptr;
    widgets::VectorEdit* m_rotation = nullptr;
    widgets::VectorEdit* m_scale = nullptr;
    int m_object = 0;
    std::vector<int> m_selected;
};

}  // namespace chiaro::app
