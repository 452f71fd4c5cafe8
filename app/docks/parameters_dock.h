#pragma once

#include "app/change.h"
#include "app/docks/dock.h"
#include "core/project/project.h"

#include <functional>

namespace chiaro::widgets {
class ParameterForm;
}

class QLabel;
class QVBoxLayout;

namespace chiaro::app {

class Document;
class PresetMenu;

/// The parameters of the method that is shown: sections, each a form over one struct of the project.
class ParametersDock : public Dock {
    Q_OBJECT

public:
    explicit ParametersDock(Document& document);
    PresetMenu* presets() const { return m_presets; }

private:
    /// What a section says of itself.
    struct Heading {
        std::string method;  ///< whose parameters these are
        QString text;
        Change::Kind kind;  ///< the change that an edit of them is
        QString note = {};
        std::vector<std::string> without = {};  ///< keys of parameters that mean nothing to the method
    };
    struct Section {
        Heading heading;
        QWidget* widget = nullptr;
        std::function<void()> show;  ///< the project's values
    };
    /// `part` gives the struct that the form edits, of the `whole` that `edit` takes.
    template <class Params, class Whole, class Part>
    void addSection(const Heading& heading, Whole project::Project::*whole, Part part,
                    void (Document::*edit)(const Whole&));
    QWidget* makeHeader();
    void addImageBased();
    void addViewAligned();
    void addViewDependent();
    void applyChange(Change change);

    Document& m_document;
    QVBoxLayout* m_layout = nullptr;
    QLabel* m_method = nullptr;
    PresetMenu* m_presets = nullptr;
    std::vector<Section> m_sections;
};

}  // namespace chiaro::app
