#pragma once

#include <QLockFile>
#include <QString>

#include <filesystem>
#include <memory>
#include <optional>

namespace chiaro::app {

/// A file beside the open project, .NAME.chiaro.lock, that tells other studios that it is open. Where none
/// can be written, as in a folder that is read-only, there is nothing to warn of.
class ProjectLock {
public:
    /// Lets go of what was held. An empty path holds nothing.
    void take(const std::filesystem::path& project);
    /// "process 1234 on workstation" when another studio has the project open.
    static std::optional<QString> holder(const std::filesystem::path& project);

private:
    std::filesystem::path m_project;
    std::unique_ptr<QLockFile> m_lock;
};

}  // namespace chiaro::app
