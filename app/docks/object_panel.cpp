#include "app/docks/object_panel.h"

#include "app/docks/scene_steps.h"
#include "app/document.h"
#include "app/meshes.h"
#include "widgets/vector_edit.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::VectorEdit;

ObjectPanel::ObjectPanel(Document& document, Meshes& meshes) : m_document(document), m_meshes(meshes) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    m_sample = new QComboBox;
    m_sample->setObjectName("object-sample");
    m_sample->setAccessibleName(tr("Sample"));
    m_sample->setToolTip(tr("The paint that the selected objects wear"));
    m_sample->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    widgets::WheelGuard::protect(m_sample);
    connect(m_sample, &QComboBox::activated, this, &ObjectPanel::dress);
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
        edit(tr("Move Object"), [&](scene::Placement& placement) { placement.position = value; });
    });
    connect(m_rotation, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        edit(tr("Turn Object"), [&](scene::Placement& placement) { placement.rotation = value; });
    });
    connect(m_scale, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        // A flat object has no inside to scale back from.
        if (value.x * value.y * value.z == 0) return showObject(m_object, m_selected);
        edit(tr("Scale Object"), [&](scene::Placement& placement) { placement.scale = value; });
    });
    connect(&document, &Document::changed, this, &ObjectPanel::applyChange);
    applyChange({});
}

VectorEdit* ObjectPanel::addVector(QGridLayout& grid, const QString& label, VectorEdit* edit) {
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(label), row, 0);
    grid.addWidget(edit, row, 1);
    connect(edit, &VectorEdit::editFinished, &m_document, &Document::finishEdit);
    return edit;
}

void ObjectPanel::applyChange(Change change) {
    if (change.kind != Change::Kind::Everything && change.kind != Change::Kind::Samples) return;
    const QSignalBlocker quiet(m_sample);
    m_sample->clear();
    for (const project::Sample& sample : m_document.project().samples)
        m_sample->addItem(QString::fromStdString(sample.name));
    m_sample->setEnabled(m_sample->count() > 0);
}

void ObjectPanel::showObject(int object, std::vector<int> selected) {
    m_object = object;
    m_selected = std::move(selected);
    const project::ObjectSettings& settings = m_document.project().objects[std::size_t(object)];
    m_sample->setCurrentIndex(settings.sample < m_sample->count() ? settings.sample : -1);
    m_position->setStep(stepFor(m_meshes.size()));
    m_position->setValue(settings.placement.position);
    m_rotation->setValue(settings.placement.rotation);
    m_scale->setValue(settings.placement.scale);
}

void ObjectPanel::edit(const QString& text, const std::function<void(scene::Placement&)>& change) {
    std::vector<project::ObjectSettings> objects = m_document.project().objects;
    // Fields of an object that is removed may lose the focus, and tell of it, only then.
    if (m_object >= int(objects.size())) return;
    change(objects[std::size_t(m_object)].placement);
    m_document.editObjects(std::move(objects), text);
}

void ObjectPanel::dress(int sample) {
    std::vector<project::ObjectSettings> objects = m_document.project().objects;
    for (const int object : m_selected) objects[std::size_t(object)].sample = sample;
    m_document.finishEdit();
    m_document.editObjects(std::move(objects), tr("Assign Sample"));
    m_document.finishEdit();
}

}  // namespace chiaro::app
