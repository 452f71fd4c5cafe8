#pragma once

#include "tests/support/support.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace chiaro::test {

/// A folder on a disk of its own that can be made full: a file system in memory that only this process sees,
/// or, where the system doesn't allow one, a limit on the size of every file that this process writes. To be
/// made before the process has other threads, once.
class SmallDisk {
public:
    SmallDisk();
    ~SmallDisk();
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return m_folder / name; }
    const std::filesystem::path& path() const { return m_folder.path(); }
    /// Whether it is a file system of its own, on which all files together have to fit.
    bool isOwn() const { return m_isOwn; }

    /// Lets that many bytes more be written to it, rounded down to pages; with a limit on files, to each.
    void leave(std::uint64_t bytes);
    /// As much space as anybody wants.
    void leaveAll();

private:
    void resize(std::uint64_t bytes) const;

    TemporaryFolder m_folder;
    bool m_isOwn = false;
};

}  // namespace chiaro::test
