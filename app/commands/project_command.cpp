#include "app/commands/project_command.h"

#include "app/document.h"

namespace chiaro::app {

project::Project& ProjectCommand::project() const {
    return m_document.m_project;
}

void ProjectCommand::tell() const {
    Q_EMIT m_document.changed(m_change);
}

}  // namespace chiaro::app
