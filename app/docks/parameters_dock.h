#pragma once

#include "app/change.h"
#include "app/docks/dock.h"

namespace chiaro::widgets {
class ParameterForm;
}

class QVBoxLayout;

namespace chiaro::app {

class Document;

/// The parameters of the method: how levels are made, how they are quilted, how they lie on the picture.
class ParametersDock : public Dock {
    Q_OBJECT

public:
    explicit ParametersDock(Document& document);

private:
    void addForm(QVBoxLayout& layout, const QString& heading, widgets::ParameterForm* form);
    void applyChange(Change change);

    Document& m_document;
    widgets::ParameterForm* m_strokes = nullptr;
    widgets::ParameterForm* m_levels = nullptr;
    widgets::ParameterForm* m_quilting = nullptr;
};

}  // namespace chiaro::app
