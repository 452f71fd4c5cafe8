#include "app/docks/scene_dock.h"

#include "app/docks/light_panel.h"
#include "app/docks/object_panel.h"
#include "app/document.h"
#include "app/meshes.h"
#include "app/scene_model.h"
#include "widgets/parameter_form.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

using widgets::ParameterForm;

namespace {

enum Page { NothingPage, ObjectPage, LightPage };

}  // namespace

SceneDock::SceneDock(Document& document, Meshes& meshes)
    : Dock("scene-dock", tr("Scene"), new QWidget),
      m_document(document),
      m_meshes(meshes),
      m_model(new SceneModel(document, this)) {
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(10);
    layout->addWidget(makeList(), 1);
    m_pages = new QStackedWidget;
    auto* nothing = new QLabel(tr("Select an object or a light."));
    nothing->setProperty("note", true);
    nothing->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_pages->addWidget(nothing);
    m_pages->addWidget(m_object = new ObjectPanel(document, meshes));
    m_pages->addWidget(m_light = new LightPanel(document, meshes));
    m_pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    layout->addWidget(m_pages);
    layout->addWidget(makeOcclusion());
    takeFiles();
    connect(&document, &Document::changed, this, &SceneDock::applyChange);
    connect(&meshes, &Meshes::sceneChanged, this, &SceneDock::showCurrent);
    applyChange({});
    selectRow(0);
}

QWidget* SceneDock::makeList() {
    auto* box = new QWidget;
    m_list = new QTreeView;
    m_list->setObjectName("scene-list");
    m_list->setAccessibleName(tr("Objects and lights"));
    m_list->setModel(m_model);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setIconSize({16, 16});
    m_list->setMinimumHeight(132);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setMinimumSectionSize(28);
    m_list->header()->setSectionResizeMode(SceneModel::Name, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(SceneModel::Eye, QHeaderView::Fixed);
    m_list->header()->resizeSection(SceneModel::Eye, 28);
    m_list->installEventFilter(this);
    auto* addMesh = widgets::makeToolButton("add", tr("Add mesh"), tr("Add the objects of a mesh file"));
    auto* addOne = widgets::makeToolButton("light-add", tr("Add light"), tr("Add a light"));
    m_duplicate = widgets::makeToolButton("duplicate", tr("Duplicate"),
                                          tr("Put copies of the selected objects in the scene (Ctrl+D)"));
    m_remove = widgets::makeToolButton("remove", tr("Remove"), tr("Remove what is selected (Delete)"));
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(2);
    for (QToolButton* button : {addMesh, addOne, m_duplicate, m_remove}) buttons->addWidget(button);
    buttons->addStretch(1);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);

    connect(addMesh, &QToolButton::clicked, this, &SceneDock::addMeshWanted);
    connect(addOne, &QToolButton::clicked, this, &SceneDock::addLight);
    connect(m_duplicate, &QToolButton::clicked, this, &SceneDock::duplicateSelected);
    connect(m_remove, &QToolButton::clicked, this, &SceneDock::removeSelected);
    connect(m_list, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (index.column() == SceneModel::Eye)
            m_model->setVisible({index.row()}, !m_model->isVisible(index.row()));
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SceneDock::showCurrent);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &SceneDock::showCurrent);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, &SceneDock::keepSelection);
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        const int last = m_model->rowCount() - 1;
        const int current = std::min(m_current, last);
        for (const int row : m_selected)
            if (row <= last)
                m_list->selectionModel()->select(m_model->index(row, 0),
                                                 QItemSelectionModel::Select | QItemSelectionModel::Rows);
        m_list->selectionModel()->setCurrentIndex(m_model->index(current, 0),
                                                  QItemSelectionModel::Select | QItemSelectionModel::Rows);
        showCurrent();
    });
    return box;
}

QWidget* SceneDock::makeOcclusion() {
    auto* section = new QWidget;
    auto* layout = new QVBoxLayout(section);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(6);
    auto* heading = new QLabel(tr("Shadows and Occlusion"));
    heading->setProperty("heading", true);
    heading->setIndent(0);
    heading->setToolTip(
        tr("Off is fastest: with shadows or ambient occlusion the CPU draws the viewport, a "
           "coarse picture first."));
    m_occlusion = widgets::makeParameterForm<scene::OcclusionParams>();
    layout->addWidget(heading);
    layout->addWidget(m_occlusion);
    connect(m_occlusion, &ParameterForm::valueEdited, this, [this] {
        scene::OcclusionParams params = m_document.project().occlusion;
        scene::OcclusionParams::table().assign(params, m_occlusion->values());
        m_document.editOcclusion(params);
    });
    connect(m_occlusion, &ParameterForm::editFinished, &m_document, &Document::finishEdit);
    return section;
}

int SceneDock::currentRow() const {
    return m_list->currentIndex().isValid() ? m_list->currentIndex().row() : -1;
}

std::vector<int> SceneDock::selectedRows() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_list->selectionModel()->selectedRows()) rows.push_back(index.row());
    std::ranges::sort(rows);
    return rows;
}

void SceneDock::addTo(QMenu& menu) {
    // Their keys are the list's own, so that they never take a letter from a text field.
    menu.addAction(widgets::icon("light-add"), tr("Add &Light"), this, &SceneDock::addLight);
    menu.addSeparator();
    menu.addAction(widgets::icon("duplicate"), tr("&Duplicate"), this, &SceneDock::duplicateSelected);
    menu.addAction(widgets::icon("eye"), tr("&Hide or Show"), this, &SceneDock::toggleSelected);
    menu.addAction(widgets::icon("remove"), tr("&Remove"), this, &SceneDock::removeSelected);
}

void SceneDock::keepSelection() {
    m_selected = selectedRows();
    m_current = std::max(0, currentRow());
}

void SceneDock::selectRow(int row) {
    m_list->selectionModel()->setCurrentIndex(
        m_model->index(row, 0), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void SceneDock::applyChange(Change change) {
    using Kind = Change::Kind;
    if (change.kind == Kind::Everything || change.kind == Kind::Occlusion)
        m_occlusion->setValues(scene::OcclusionParams::table().values(m_document.project().occlusion));
    if (change.kind == Kind::Everything || change.kind == Kind::Samples || change.kind == Kind::Objects ||
        change.kind == Kind::Lights)
        showCurrent();
    if (change.kind != Kind::Everything) return;
    selectRow(0);
    Q_EMIT lightSelected(0);
}

void SceneDock::showCurrent() {
    const project::Project& project = m_document.project();
    if (m_model->objectCount() != int(project.objects.size()) ||
        m_model->lightCount() != int(project.lights.size()))
        return;  // the model hears of the change later, and calls here again
    const std::vector<int> rows = selectedRows();
    const int row = currentRow();
    const bool hasObject = std::ranges::any_of(rows, [this](int one) { return !m_model->isLight(one); });
    m_duplicate->setEnabled(hasObject);
    m_remove->setEnabled(!rows.empty());
    if (row < 0 || row >= m_model->rowCount() || rows.empty()) return m_pages->setCurrentIndex(NothingPage);
    if (m_model->isLight(row)) {
        m_pages->setCurrentIndex(LightPage);
        m_light->showLight(m_model->lightAt(row));
        Q_EMIT lightSelected(m_model->lightAt(row));
        return;
    }
    std::vector<int> objects;
    for (const int selected : rows)
        if (!m_model->isLight(selected)) objects.push_back(m_model->objectAt(selected));
    m_pages->setCurrentIndex(ObjectPage);
    m_object->showObject(m_model->objectAt(row), std::move(objects));
}

void SceneDock::addLight() {
    std::vector<scene::Light> lights = m_document.project().lights;
    scene::Light light;
    if (!lights.empty()) light = {.vector = {0.8f, 0.3f, 0.3f}, .intensity = 0.25f, .wrap = false};
    lights.push_back(light);
    m_document.finishEdit();
    m_document.editLights(lights, tr("Add Light"));
    m_document.finishEdit();
    selectRow(m_model->rowOfLight(int(lights.size()) - 1));
}

void SceneDock::removeSelected() {
    std::vector<int> objects;
    std::vector<scene::Light> lights = m_document.project().lights;
    const std::vector<int> rows = selectedRows();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        if (m_model->isLight(*row))
            lights.erase(lights.begin() + m_model->lightAt(*row));
        else
            objects.push_back(m_model->objectAt(*row));
    if (rows.empty()) return;
    m_document.finishEdit();
    const bool isMixed = !objects.empty() && lights.size() != m_document.project().lights.size();
    if (isMixed) m_document.undoStack().beginMacro(tr("Remove"));
    m_document.editLights(lights, tr("Remove Light"));
    if (!objects.empty()) m_document.removeObjects(objects);
    if (isMixed) m_document.undoStack().endMacro();
    m_document.finishEdit();
    selectRow(std::min(rows.front(), m_model->rowCount() - 1));
}

void SceneDock::duplicateSelected() {
    std::vector<int> objects;
    for (const int row : selectedRows())
        if (!m_model->isLight(row)) objects.push_back(m_model->objectAt(row));
    if (objects.empty()) return;
    m_document.finishEdit();
    const std::vector<int> copies = m_document.duplicateObjects(objects);
    selectRow(copies.front());
    for (const int copy : copies)
        m_list->selectionModel()->select(m_model->index(copy, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
}

void SceneDock::toggleSelected() {
    const std::vector<int> rows = selectedRows();
    const bool anyShown = std::ranges::any_of(rows, [this](int row) { return m_model->isVisible(row); });
    m_model->setVisible(rows, !anyShown);
}

bool SceneDock::isListKey(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace) return removeSelected(), true;
    if (event.key() == Qt::Key_H && event.modifiers() == Qt::NoModifier) return toggleSelected(), true;
    if (event.key() == Qt::Key_D && event.modifiers() == Qt::ControlModifier)
        return duplicateSelected(), true;
    return false;
}

bool SceneDock::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress)
        return isListKey(*static_cast<QKeyEvent*>(event));
    return Dock::eventFilter(watched, event);
}

}  // namespace chiaro::app
