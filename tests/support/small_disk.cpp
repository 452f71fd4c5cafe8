#include "tests/support/small_disk.h"

#include <spdlog/fmt/fmt.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/statvfs.h>

#include <csignal>
#include <fstream>
#include <sched.h>
#include <unistd.h>

namespace chiaro::test {

namespace {

constexpr std::uint64_t roomy = std::uint64_t(512) << 20;

void writeTo(const char* file, const std::string& text) {
    std::ofstream(file) << text;
}

/// Mounts of this process are then its own. Who is no root becomes one in a name space that knows nobody
/// else.
bool leaveMountsOfOthers() {
    const uid_t user = getuid();
    const gid_t group = getgid();
    if (unshare(CLONE_NEWNS) != 0) {
        if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
        writeTo("/proc/self/setgroups", "deny");
        writeTo("/proc/self/uid_map", fmt::format("0 {} 1", user));
        writeTo("/proc/self/gid_map", fmt::format("0 {} 1", group));
    }
    return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

void limitFiles(rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace

SmallDisk::SmallDisk() {
    m_isOwn = leaveMountsOfOthers() && mount("chiaro-test", m_folder.path().c_str(), "tmpfs", 0,
                                             fmt::format("size={}", roomy).c_str()) == 0;
    if (!m_isOwn) std::signal(SIGXFSZ, SIG_IGN);
}

SmallDisk::~SmallDisk() {
    if (m_isOwn) umount2(m_folder.path().c_str(), MNT_DETACH);
}

void SmallDisk::leave(std::uint64_t bytes) {
    if (!m_isOwn) return limitFiles(bytes);
    struct statvfs disk {};
    statvfs(m_folder.path().c_str(), &disk);
    const std::uint64_t used = (disk.f_blocks - disk.f_bfree) * disk.f_frsize;
    // A size of 0 would be no limit at all.
    resize(std::max<std::uint64_t>((used + bytes) / disk.f_frsize, 1) * disk.f_frsize);
}

void SmallDisk::leaveAll() {
    if (m_isOwn)
        resize(roomy);
    else
        limitFiles(RLIM_INFINITY);
}

void SmallDisk::resize(std::uint64_t bytes) const {
    if (mount(nullptr, m_folder.path().c_str(), nullptr, MS_REMOUNT, fmt::format("size={}", bytes).c_str()) !=
        0)
        throw std::runtime_error("the disk could not be resized");
}

}  // namespace chiaro::test
