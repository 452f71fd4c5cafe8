#include "app/project_lock.h"

#include "app/lock_file.h"

#include <spdlog/fmt/fmt.h>

#include <QtWidgets>

namespace chiaro::app {

namespace {

std::unique_ptr<QLockFile> lockOf(const std::filesystem::path& project) {
    return lockAt(project.parent_path() / fmt::format(".{}.lock", project.filename().string()));
}

}  // namespace

void ProjectLock::take(const std::filesystem::path& project) {
    if (project == m_project) return;
    m_project = project;
    m_lock.reset();
    if (project.empty()) return;
    m_lock = lockOf(project);
    m_lock->tryLock();
}

std::optional<QString> ProjectLock::holder(const std::filesystem::path& project) {
    const auto lock = lockOf(project);
    if (lock->tryLock() || lock->error() != QLockFile::LockFailedError) return std::nullopt;
    qint64 process = 0;
    QString host, program;
    lock->getLockInfo(&process, &host, &program);
    if (process == QCoreApplication::applicationPid() && host == QSysInfo::machineHostName())
        return std::nullopt;
    return QObject::tr("process %1 on %2").arg(process).arg(host);
}

}  // namespace chiaro::app
