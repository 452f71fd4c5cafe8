#include "app/docks/parameters_dock.h"

#include "app/document.h"
#include "app/preset_menu.h"
#include "core/project/render_method.h"
#include "widgets/core_text.h"
#include "widgets/parameter_form.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::ParameterForm;

namespace {

QWidget* sectionWidget(const QString& heading, const QString& note, ParameterForm* form) {
    auto* section = new QWidget;
    auto* layout = new QVBoxLayout(section);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->setSpacing(6);
    auto* label = new QLabel(heading);
    label->setProperty("heading", true);
    label->setIndent(0);
    layout->addWidget(label);
    if (!note.isEmpty()) {
        auto* explanation = new QLabel(note);
        explanation->setProperty("note", true);
        explanation->setWordWrap(true);
        layout->addWidget(explanation);
    }
    layout->addWidget(form);
    return section;
}

/// Of a struct that is edited whole.
constexpr auto itself = [](auto& params) -> auto& {
    return params;
};
constexpr auto itsQuilting = [](auto& params) -> auto& {
    return params.quilt;
};

}  // namespace

ParametersDock::ParametersDock(Document& document)
    : Dock("parameters-dock", tr("Parameters"), new QWidget),
      m_document(document),
      m_layout(new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget())) {
    m_layout->setContentsMargins(10, 8, 10, 2);
    m_layout->setSpacing(6);
    m_layout->addWidget(makeHeader());
    addImageBased();
    addViewAligned();
    addViewDependent();
    m_layout->addStretch(1);
    connect(&document, &Document::changed, this, &ParametersDock::applyChange);
    applyChange({});
}

QWidget* ParametersDock::makeHeader() {
    using project::PresetKind;
    m_method = new QLabel;
    m_method->setProperty("note", true);
    m_presets = new PresetMenu(
        PresetKind::Method, PresetMenu::standardFolder(PresetKind::Method),
        [this] { return project::MethodPreset::of(m_document.project()); },
        [this](const project::Preset& preset) {
            return std::get<project::MethodPreset>(preset).method == m_document.project().method;
        });
    connect(m_presets, &PresetMenu::failed, this, &ParametersDock::failed);
    connect(m_presets, &PresetMenu::chosen, this, [this](const project::Preset& preset) {
        m_document.applyPreset(std::get<project::MethodPreset>(preset));
    });
    auto* header = new QWidget;
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_method, 1);
    row->addWidget(m_presets->makeButton());
    return header;
}

void ParametersDock::addImageBased() {
    using Kind = Change::Kind;
    using project::Project;
    addSection<methods::ImageBasedParams>({"image-based", tr("Synthesis"), Kind::ImageBased},
                                          &Project::imageBased, itself, &Document::editImageBased);
    addSection<synthesis::QuiltParams>({"image-based", tr("Quilting"), Kind::ImageBased},
                                       &Project::imageBased, itsQuilting, &Document::editImageBased);
    addSection<methods::CoherenceParams>({"image-based", tr("Coherence"), Kind::Coherence,
                                          tr("For animations; the picture here stays as it is.")},
                                         &Project::coherence, itself, &Document::editCoherence);
}

void ParametersDock::addViewAligned() {
    using Kind = Change::Kind;
    using project::Project;
    addSection<methods::ViewAlignedParams>({"view-aligned", tr("Strokes"), Kind::ViewAligned},
                                           &Project::viewAligned, itself, &Document::editViewAligned);
    addSection<synthesis::LevelParams>({"view-aligned", tr("Levels"), Kind::Levels}, &Project::levels, itself,
                                       &Document::editLevels);
    addSection<synthesis::QuiltParams>({"view-aligned", tr("Quilting"), Kind::Levels}, &Project::levels,
                                       itsQuilting, &Document::editLevels);
}

void ParametersDock::addViewDependent() {
    using Kind = Change::Kind;
    using project::Project;
    addSection<methods::ViewDependentParams>({"view-dependent", tr("Blending"), Kind::ViewDependent},
                                             &Project::viewDependent, itself, &Document::editViewDependent);
    addSection<views::ViewParams>({"view-dependent", tr("Views"), Kind::Views}, &Project::views, itself,
                                  &Document::editViews);
    addSection<synthesis::LevelParams>({.method = "view-dependent",
                                        .text = tr("Levels"),
                                        .kind = Kind::Levels,
                                        .without = {"size", "tiling"}},
                                       &Project::levels, itself, &Document::editLevels);
    addSection<synthesis::QuiltParams>({"view-dependent", tr("Quilting"), Kind::Levels}, &Project::levels,
                                       itsQuilting, &Document::editLevels);
}

template <class Params, class Whole, class Part>
void ParametersDock::addSection(const Heading& heading, Whole project::Project::*whole, Part part,
                                void (Document::*edit)(const Whole&)) {
    const auto specs = Params::table().specs();
    const std::vector<double> defaults = Params::table().values(Params{});
    std::vector<std::size_t> rows;  // of the form, as indices in the table
    std::vector<ParameterSpec> shownSpecs;
    std::vector<double> shownDefaults;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        if (std::ranges::find(heading.without, specs[i].key) != heading.without.end()) continue;
        rows.push_back(i);
        shownSpecs.push_back(specs[i]);
        shownDefaults.push_back(defaults[i]);
    }
    auto* form = new ParameterForm(std::move(shownSpecs), std::move(shownDefaults));
    QWidget* section = sectionWidget(heading.text, heading.note, form);
    section->setObjectName(QString::fromStdString(heading.method) + "/" + heading.text);
    m_layout->addWidget(section);
    connect(form, &ParameterForm::valueEdited, this, [this, form, rows, whole, part, edit] {
        Whole edited = m_document.project().*whole;
        std::vector<double> values = Params::table().values(part(edited));
        for (std::size_t i = 0; i < rows.size(); ++i) values[rows[i]] = form->values()[i];
        Params::table().assign(part(edited), values);
        (m_document.*edit)(edited);
    });
    connect(form, &ParameterForm::editFinished, &m_document, &Document::finishEdit);
    m_sections.push_back({heading, section, [this, form, rows, whole, part] {
                              const std::vector<double> values =
                                  Params::table().values(part(m_document.project().*whole));
                              std::vector<double> shown;
                              for (const std::size_t row : rows) shown.push_back(values[row]);
                              form->setValues(shown);
                          }});
}

void ParametersDock::applyChange(Change change) {
    using Kind = Change::Kind;
    m_method->setText(widgets::coreText(project::renderMethod(m_document.project().method).label));
    for (const Section& section : m_sections) {
        if (change.kind == Kind::Everything || change.kind == section.heading.kind) section.show();
        if (change.kind == Kind::Everything || change.kind == Kind::Method)
            section.widget->setVisible(section.heading.method == m_document.project().method);
    }
}

}  // namespace chiaro::app
