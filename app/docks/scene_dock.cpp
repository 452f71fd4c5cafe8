#include "app/docks/scene_dock.h"

#include "app/document.h"
#include "app/meshes.h"
#include "app/scene_model.h"
#include "widgets/parameter_form.h"
#include "widgets/tool_button.h"
#include "widgets/vector_edit.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

namespace chiaro::app {

using widgets::ParameterForm;
using widgets::VectorEdit;

namespace {

enum Page { NothingPage, ObjectPage, LightPage };

/// The numbers of a light that a form shows.
std::vector<ParameterSpec> lightSpecs() {
    return {ParameterSpec::choice("light-kind", "Kind", {"directional", "point"},
                                  "Far away in a direction, or at a point in the scene"),
            ParameterSpec::real("intensity", "Intensity", "", 0, 4, 0.05,
                                "How much it gives; lights add up, and L ends at 1"),
            ParameterSpec::boolean("wrap", "Wrap",
                                   "Light goes around to the far side, (1 + n·l)/2; off: half is dark")};
}

std::vector<double> valuesOf(const scene::Light& light) {
    return {double(light.kind), double(light.intensity), double(light.wrap)};
}

/// 1, 2 or 5 times a power of ten, about a fiftieth of the scene.
double stepFor(float radius) {
    const double wanted = std::max(double(radius), 1e-6) / 50;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= wanted) return step * power;
    return 10 * power;
}

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    return paths;
}

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
    m_pages->addWidget(makeObjectPage());
    m_pages->addWidget(makeLightPage());
    m_pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    layout->addWidget(m_pages);
    layout->addWidget(makeOcclusion());
    setAcceptDrops(true);
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

VectorEdit* SceneDock::addVector(QGridLayout& grid, const QString& label, VectorEdit* edit) {
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(label), row, 0);
    grid.addWidget(edit, row, 1);
    connect(edit, &VectorEdit::editFinished, &m_document, &Document::finishEdit);
    return edit;
}

QWidget* SceneDock::makeObjectPage() {
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    m_sample = new QComboBox;
    m_sample->setObjectName("object-sample");
    m_sample->setAccessibleName(tr("Sample"));
    m_sample->setToolTip(tr("The paint that the selected objects wear"));
    m_sample->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    widgets::WheelGuard::protect(m_sample);
    connect(m_sample, &QComboBox::activated, this, &SceneDock::dressSelected);
    grid->addWidget(new QLabel(tr("Sample")), 0, 0);
    grid->addWidget(m_sample, 0, 1);
    m_position =
        addVector(*grid, tr("Position"), new VectorEdit({.key = "position", .name = tr("Position")}));
    m_rotation = addVector(*grid, tr("Rotation"),
                           new VectorEdit({.key = "rotation",
                                           .name = tr("Rotation"),
                                           .unit = "°",
                                           .minimum = -36000,
                                           .maximum = 36000,
                                           .step = 5,
                                           .decimals = 2}));
    m_scale = addVector(*grid, tr("Scale"),
                        new VectorEdit({.key = "scale",
                                        .name = tr("Scale"),
                                        .unit = {},
                                        .minimum = -1000,
                                        .maximum = 1000,
                                        .step = 0.05,
                                        .decimals = 3,
                                        .standard = glm::vec3(1),
                                        .hasLink = true}));
    connect(m_position, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        editObject(tr("Move Object"), [&](scene::Placement& placement) { placement.position = value; });
    });
    connect(m_rotation, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        editObject(tr("Turn Object"), [&](scene::Placement& placement) { placement.rotation = value; });
    });
    connect(m_scale, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        // A flat object has no inside to scale back from.
        if (value.x * value.y * value.z == 0) return showCurrent();
        editObject(tr("Scale Object"), [&](scene::Placement& placement) { placement.scale = value; });
    });
    return page;
}

QWidget* SceneDock::makeLightPage() {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    m_light = new ParameterForm(lightSpecs(), valuesOf(scene::Light{}));
    m_vectorLabel = new QLabel;
    m_vector = new VectorEdit({.key = "light", .name = tr("Light"), .standard = scene::Light{}.vector});
    auto* row = new QHBoxLayout;
    row->addWidget(m_vectorLabel);
    row->addWidget(m_vector, 1);
    layout->addWidget(m_light);
    layout->addLayout(row);
    connect(m_light, &ParameterForm::valueEdited, this, &SceneDock::editLightForm);
    connect(m_light, &ParameterForm::editFinished, &m_document, &Document::finishEdit);
    connect(m_vector, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        const int light = m_model->lightAt(currentRow());
        const bool isPoint =
            m_document.project().lights[std::size_t(light)].kind == scene::Light::Kind::Point;
        if (!isPoint && glm::length(value) == 0) return showCurrent();
        m_document.editLight(light, value);
    });
    connect(m_vector, &VectorEdit::editFinished, &m_document, &Document::finishEdit);
    return page;
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

float SceneDock::sceneRadius() const {
    const float radius = scene::boundsOf(m_meshes.scene()).radius;
    return radius > 0 ? radius : 1;
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
    if (change.kind == Kind::Everything || change.kind == Kind::Samples) showSamples();
    if (change.kind == Kind::Everything || change.kind == Kind::Occlusion)
        m_occlusion->setValues(scene::OcclusionParams::table().values(m_document.project().occlusion));
    if (change.kind == Kind::Everything || change.kind == Kind::Samples || change.kind == Kind::Objects ||
        change.kind == Kind::Lights)
        showCurrent();
    if (change.kind == Kind::Everything) selectRow(0);
}

void SceneDock::showSamples() {
    const QSignalBlocker quiet(m_sample);
    m_sample->clear();
    for (const project::Sample& sample : m_document.project().samples)
        m_sample->addItem(QString::fromStdString(sample.name));
    m_sample->setEnabled(m_sample->count() > 0);
}

void SceneDock::showCurrent() {
    const std::vector<int> rows = selectedRows();
    const int row = currentRow();
    const bool hasObject = std::ranges::any_of(rows, [this](int one) { return !m_model->isLight(one); });
    m_duplicate->setEnabled(hasObject);
    m_remove->setEnabled(!rows.empty());
    if (row < 0 || row >= m_model->rowCount() || rows.empty()) return m_pages->setCurrentIndex(NothingPage);
    if (m_model->isLight(row))
        showLight(m_model->lightAt(row));
    else
        showObject(m_model->objectAt(row));
}

void SceneDock::showObject(int object) {
    const project::ObjectSettings& settings = m_document.project().objects[std::size_t(object)];
    m_pages->setCurrentIndex(ObjectPage);
    m_sample->setCurrentIndex(settings.sample < m_sample->count() ? settings.sample : -1);
    m_position->setStep(stepFor(sceneRadius()));
    m_position->setValue(settings.placement.position);
    m_rotation->setValue(settings.placement.rotation);
    m_scale->setValue(settings.placement.scale);
}

void SceneDock::showLight(int light) {
    const scene::Light& one = m_document.project().lights[std::size_t(light)];
    const bool isPoint = one.kind == scene::Light::Kind::Point;
    m_pages->setCurrentIndex(LightPage);
    m_light->setValues(valuesOf(one));
    m_vectorLabel->setText(isPoint ? tr("Position") : tr("Direction"));
    m_vector->setToolTip(isPoint ? tr("Where the light stands")
                                 : tr("From the scene towards the light; only the direction counts"));
    m_vector->setStep(isPoint ? stepFor(sceneRadius()) : 0.05);
    m_vector->setValue(one.vector);
    Q_EMIT lightSelected(light);
}

template <class Edit>
void SceneDock::editObject(const QString& text, Edit edit) {
    std::vector<project::ObjectSettings> objects = m_document.project().objects;
    edit(objects[std::size_t(m_model->objectAt(currentRow()))].placement);
    m_document.editObjects(std::move(objects), text);
}

void SceneDock::dressSelected(int sample) {
    std::vector<project::ObjectSettings> objects = m_document.project().objects;
    for (const int row : selectedRows())
        if (!m_model->isLight(row)) objects[std::size_t(m_model->objectAt(row))].sample = sample;
    m_document.finishEdit();
    m_document.editObjects(std::move(objects), tr("Assign Sample"));
    m_document.finishEdit();
}

void SceneDock::editLightForm() {
    const int index = m_model->lightAt(currentRow());
    std::vector<scene::Light> lights = m_document.project().lights;
    scene::Light& light = lights[std::size_t(index)];
    const std::vector<double>& values = m_light->values();
    const auto kind = scene::Light::Kind(int(values[0]));
    if (kind != light.kind) {
        // It goes on shining from the same side.
        const scene::Bounds bounds = scene::boundsOf(m_meshes.scene());
        const float away = 2 * sceneRadius();
        const glm::vec3 way = light.vector - bounds.center();
        light.vector = kind == scene::Light::Kind::Point ? bounds.center() + light.direction({}) * away
                       : glm::length(way) > 0            ? glm::normalize(way)
                                                         : scene::Light{}.vector;
    }
    light.kind = kind;
    light.intensity = float(values[1]);
    light.wrap = values[2] != 0;
    m_document.editLights(lights, tr("Change Light"));
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
    if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace)
        return removeSelected(), true;
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

void SceneDock::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void SceneDock::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    Q_EMIT filesDropped(localFiles(*event->mimeData()));
}

}  // namespace chiaro::app
