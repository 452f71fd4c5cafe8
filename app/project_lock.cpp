#include "app/project_lock.h"

#include <spdlog/fmt/fmt.h>

#include <QtWidgets>

namespace chiaro::app {

namespace {

std::unique_ptr<QLockFile> lockFor(const std::filesystem::path& project) {
    const auto file = project.parent_path() / fmt::format(".{}.lock", project.filename().string());
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(file.string()));
    lock->setStaleLockTime(0);  // it is stale when its process runs no more, however old it is
    return lock;
}

}  // namespace

void ProjectLock::take(const std::filesystem::path& project) {
    if (project == m_project) return;
    m_project = project;
    m_lock.reset();
    if (project.empty()) return;
    m_lock = lockFor(project);
    m_lock->tryLock();
}

std::optional<QString> ProjectLock::holder(const std::filesystem::path& project) {
    const auto lock = lockFor(project);
    if (lock->tryLock() || lock->error() != QLockFile::LockFailedError) return std::nullopt;
    qint64 process = 0;
    QString host, program;
    lock->getLockInfo(&process, &host, &program);
    if (process == QCoreApplication::applicationPid() && host == QSysInfo::machineHostName())
        return std::nullopt;
    return QObject::tr("process %1 on %2").arg(process).arg(host);
}

}  // namespace chiaro::app
