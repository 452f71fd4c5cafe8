#include "app/docks/parameters_dock.h"

#include "app/document.h"
#include "widgets/parameter_form.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::ParameterForm;

ParametersDock::ParametersDock(Document& document)
    : Dock("parameters-dock", tr("Parameters"), new QWidget),
      m_document(document),
      m_strokes(widgets::makeParameterForm<methods::ViewAlignedParams>()),
      m_levels(widgets::makeParameterForm<synthesis::LevelParams>()),
      m_quilting(widgets::makeParameterForm<synthesis::QuiltParams>()) {
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(6);
    addForm(*layout, tr("Strokes"), m_strokes);
    addForm(*layout, tr("Levels"), m_levels);
    addForm(*layout, tr("Quilting"), m_quilting);
    layout->addStretch(1);

    connect(m_strokes, &ParameterForm::valueEdited, this, [this] {
        methods::ViewAlignedParams params = m_document.project().viewAligned;
        methods::ViewAlignedParams::table().assign(params, m_strokes->values());
        m_document.editViewAligned(params);
    });
    connect(m_levels, &ParameterForm::valueEdited, this, [this] {
        synthesis::LevelParams params = m_document.project().levels;
        synthesis::LevelParams::table().assign(params, m_levels->values());
        m_document.editLevels(params);
    });
    connect(m_quilting, &ParameterForm::valueEdited, this, [this] {
        synthesis::LevelParams params = m_document.project().levels;
        synthesis::QuiltParams::table().assign(params.quilt, m_quilting->values());
        m_document.editLevels(params);
    });
    for (ParameterForm* form : {m_strokes, m_levels, m_quilting})
        connect(form, &ParameterForm::editFinished, &document, &Document::finishEdit);
    connect(&document, &Document::changed, this, &ParametersDock::applyChange);
    applyChange({});
}

void ParametersDock::addForm(QVBoxLayout& layout, const QString& heading, ParameterForm* form) {
    auto* label = new QLabel(heading);
    label->setProperty("heading", true);
    label->setIndent(0);
    if (layout.count() > 0) layout.addSpacing(8);
    layout.addWidget(label);
    layout.addWidget(form);
}

void ParametersDock::applyChange(Change change) {
    using Kind = Change::Kind;
    const project::Project& project = m_document.project();
    if (change.kind == Kind::Everything || change.kind == Kind::ViewAligned)
        m_strokes->setValues(methods::ViewAlignedParams::table().values(project.viewAligned));
    if (change.kind == Kind::Everything || change.kind == Kind::Levels) {
        m_levels->setValues(synthesis::LevelParams::table().values(project.levels));
        m_quilting->setValues(synthesis::QuiltParams::table().values(project.levels.quilt));
    }
}

}  // namespace chiaro::app
