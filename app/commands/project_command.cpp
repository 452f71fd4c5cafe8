#include "app/commands/project_command.h"

#include "app/document.h"

#include <QScopedValueRollback>

namespace chiaro::app {

project::Project& ProjectCommand::project() const {
    return m_document.m_project;
}

void ProjectCommand::tell() const {
    const QScopedValueRollback telling(m_document.m_isTelling, true);
    Q_EMIT m_document.changed(m_change);
}

}  // namespace chiaro::app
