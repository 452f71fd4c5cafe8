#pragma once

#include "app/change.h"
#include "core/project/project.h"

#include <QUndoCommand>

namespace chiaro::app {

class Document;

/// What may change a document's project; everybody else pushes one of these.
class ProjectCommand : public QUndoCommand {
protected:
    ProjectCommand(Document& document, Change change, const QString& text)
        : QUndoCommand(text), m_document(document), m_change(change) {}

    Change change() const { return m_change; }
    project::Project& project() const;
    /// Tells the document's listeners.
    void tell() const;

private:
    Document& m_document;
    Change m_change;
};

}  // namespace chiaro::app
