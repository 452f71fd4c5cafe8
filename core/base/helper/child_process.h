#pragma once

#include "core/base/helper/file_handle.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chiaro::helper {

/// A program that runs with one socket, its handle 3, and nothing else of ours. It is waited for from its
/// start on, by a thread that sleeps, so it never stays as a zombie. Killed with its owner.
class ChildProcess {
public:
    static constexpr int socketHandle = 3;

    /// Starts it. Nothing of this process runs between fork and exec. Throws std::system_error.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const FileHandle& socket);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    int id() const;
    /// Returns at once; harmless when it has ended already.
    void kill();
    /// How it ended, once it did: "crashed (Segmentation fault)", "ended with status 3". Waits up to a
    /// second.
    std::string howItEnded() const;

private:
    struct State;
    std::shared_ptr<State> m_state;
};

}  // namespace chiaro::helper
