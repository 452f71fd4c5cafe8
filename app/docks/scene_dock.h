#pragma once

#include "app/change.h"
#include "app/docks/dock.h"

#include <vector>

class QMenu;
class QStackedWidget;
class QToolButton;
class QTreeView;

namespace chiaro::widgets {
class ParameterForm;
}

namespace chiaro::app {

class Document;
class LightPanel;
class Meshes;
class ObjectPanel;
class SceneModel;

/// The objects and lights of the document: added, removed, renamed, hidden, placed, and which sample each
/// object wears; and what shadows they cast. It says which light is selected; the viewport turns that one.
class SceneDock : public Dock {
    Q_OBJECT

public:
    SceneDock(Document& document, Meshes& meshes);

    SceneModel& model() { return *m_model; }
    QTreeView* list() const { return m_list; }
    void selectRow(int row);
    /// What the list's buttons and keys do.
    void addTo(QMenu& menu);

public Q_SLOTS:
    void addLight();
    void removeSelected();
    void duplicateSelected();
    /// Hides what is selected, or shows it when all of it is hidden.
    void toggleSelected();

Q_SIGNALS:
    void addMeshWanted();
    /// The light that drags in the viewport turn.
    void lightSelected(int light);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeList();
    QWidget* makeOcclusion();
    void applyChange(Change change);
    void showCurrent();
    void keepSelection();
    bool isListKey(const class QKeyEvent& event);

    int currentRow() const;
    std::vector<int> selectedRows() const;

    Document& m_document;
    Meshes& m_meshes;
    SceneModel* m_model = nullptr;
    QTreeView* m_list = nullptr;
    QToolButton* m_duplicate = nullptr;
    QToolButton* m_remove = nullptr;
    QStackedWidget* m_pages = nullptr;
    ObjectPanel* m_object = nullptr;
    LightPanel* m_light = nullptr;
    widgets::ParameterForm* m_occlusion = nullptr;
    std::vector<int> m_selected;  ///< rows, to select again after a reset
    int m_current = 0;
};

}  // namespace chiaro::app
