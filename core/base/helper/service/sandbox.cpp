#include "core/base/helper/service/sandbox.h"

#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <unistd.h>

namespace chiaro::helper {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;  // which maps terabytes of address space and makes system calls of its own
#else
constexpr bool isSanitized = false;
#endif

bool limit(__rlimit_resource resource, rlim_t most) {
    rlimit wanted{most, most};
    rlimit allowed{};
    if (::getrlimit(resource, &allowed) == 0 && allowed.rlim_max < most)
        wanted = {allowed.rlim_max, allowed.rlim_max};
    return ::setrlimit(resource, &wanted) == 0;
}

/// No rule follows: whatever is handled is allowed nowhere.
bool forbidWritingFiles() {
    landlock_ruleset_attr handled{};
    handled.handled_access_fs =
        LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
        LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
        LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
        LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
    const auto ruleset = int(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (ruleset < 0) return false;
    const bool done = ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    ::close(ruleset);
    return done;
}

/// What readers, the C++ library and its threads call. Nothing here opens a way out by itself; those that
/// could are allowed with certain arguments only, below.
constexpr std::array harmlessCalls{SCMP_SYS(read),
                                   SCMP_SYS(pread64),
                                   SCMP_SYS(readv),
                                   SCMP_SYS(preadv),
                                   SCMP_SYS(write),
                                   SCMP_SYS(writev),
                                   SCMP_SYS(close),
                                   SCMP_SYS(fstat),
                                   SCMP_SYS(stat),
                                   SCMP_SYS(lstat),
                                   SCMP_SYS(newfstatat),
                                   SCMP_SYS(statx),
                                   SCMP_SYS(statfs),
                                   SCMP_SYS(fstatfs),
                                   SCMP_SYS(lseek),
                                   SCMP_SYS(access),
                                   SCMP_SYS(faccessat),
                                   SCMP_SYS(faccessat2),
                                   SCMP_SYS(readlink),
                                   SCMP_SYS(readlinkat),
                                   SCMP_SYS(getcwd),
                                   SCMP_SYS(getdents64),
                                   SCMP_SYS(fadvise64),
                                   SCMP_SYS(dup),
                                   SCMP_SYS(dup2),
                                   SCMP_SYS(dup3),
                                   SCMP_SYS(fcntl),
                                   SCMP_SYS(pipe2),
                                   SCMP_SYS(eventfd2),
                                   SCMP_SYS(memfd_create),
                                   SCMP_SYS(ftruncate),
                                   SCMP_SYS(poll),
                                   SCMP_SYS(ppoll),
                                   SCMP_SYS(select),
                                   SCMP_SYS(pselect6),
                                   SCMP_SYS(sendmsg),
                                   SCMP_SYS(recvmsg),
                                   SCMP_SYS(getsockopt),
                                   SCMP_SYS(mmap),
                                   SCMP_SYS(mprotect),
                                   SCMP_SYS(munmap),
                                   SCMP_SYS(mremap),
                                   SCMP_SYS(madvise),
                                   SCMP_SYS(brk),
                                   SCMP_SYS(mincore),
                                   SCMP_SYS(membarrier),
                                   SCMP_SYS(get_mempolicy),
                                   SCMP_SYS(futex),
                                   SCMP_SYS(futex_waitv),
                                   SCMP_SYS(set_robust_list),
                                   SCMP_SYS(get_robust_list),
                                   SCMP_SYS(rseq),
                                   SCMP_SYS(set_tid_address),
                                   SCMP_SYS(arch_prctl),
                                   SCMP_SYS(rt_sigaction),
                                   SCMP_SYS(rt_sigprocmask),
                                   SCMP_SYS(rt_sigreturn),
                                   SCMP_SYS(sigaltstack),
                                   SCMP_SYS(restart_syscall),
                                   SCMP_SYS(exit),
                                   SCMP_SYS(exit_group),
                                   SCMP_SYS(gettid),
                                   SCMP_SYS(getpid),
                                   SCMP_SYS(getppid),
                                   SCMP_SYS(getuid),
                                   SCMP_SYS(geteuid),
                                   SCMP_SYS(getgid),
                                   SCMP_SYS(getegid),
                                   SCMP_SYS(sched_yield),
                                   SCMP_SYS(sched_getaffinity),
                                   SCMP_SYS(sched_getparam),
                                   SCMP_SYS(sched_getscheduler),
                                   SCMP_SYS(sched_get_priority_max),
                                   SCMP_SYS(sched_get_priority_min),
                                   SCMP_SYS(getcpu),
                                   SCMP_SYS(clock_gettime),
                                   SCMP_SYS(clock_getres),
                                   SCMP_SYS(clock_nanosleep),
                                   SCMP_SYS(nanosleep),
                                   SCMP_SYS(gettimeofday),
                                   SCMP_SYS(time),
                                   SCMP_SYS(times),
                                   SCMP_SYS(getrandom),
                                   SCMP_SYS(getrlimit),
                                   SCMP_SYS(getrusage),
                                   SCMP_SYS(sysinfo),
                                   SCMP_SYS(uname)};

bool allow(scmp_filter_ctx filter, int call, std::initializer_list<scmp_arg_cmp> conditions = {}) {
    return ::seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, unsigned(conditions.size()),
                                    conditions.begin()) == 0;
}

bool allowWithConditions(scmp_filter_ctx filter) {
    constexpr scmp_datum_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
    const auto self = scmp_datum_t(::getpid());
    return allow(filter, SCMP_SYS(open), {SCMP_A1(SCMP_CMP_MASKED_EQ, writing, 0)}) &&
           allow(filter, SCMP_SYS(openat), {SCMP_A2(SCMP_CMP_MASKED_EQ, writing, 0)}) &&
           allow(filter, SCMP_SYS(clone), {SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD)}) &&
           allow(filter, SCMP_SYS(tgkill), {SCMP_A0(SCMP_CMP_EQ, self)}) &&  // abort()
           allow(filter, SCMP_SYS(prlimit64), {SCMP_A2(SCMP_CMP_EQ, 0)}) &&
           allow(filter, SCMP_SYS(prctl), {SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME)});
}

/// Every other system call answers as if this kernel didn't have it, which libraries know how to take.
bool forbidOtherSystemCalls() {
    const scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(ENOSYS));
    if (!filter) return false;
    bool done = allowWithConditions(filter);
    for (const int call : harmlessCalls) done = done && allow(filter, call);
    done = done && ::seccomp_load(filter) == 0;
    ::seccomp_release(filter);
    return done;
}

}  // namespace

std::string shutIn(std::size_t megabytes) {
    std::string open;
    const auto expect = [&](bool done, const char* otherwise) {
        if (!done) open += (open.empty() ? "" : ", ") + std::string(otherwise);
    };
    expect(!isSanitized && limit(RLIMIT_AS, rlim_t(megabytes) << 20), "its memory is not limited");
    limit(RLIMIT_CORE, 0);
    const bool isFinal = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
    expect(isFinal && forbidWritingFiles(), "this system has no Landlock to keep it from writing files");
    expect(!isSanitized && isFinal && forbidOtherSystemCalls(),
           "this system has no seccomp filter to keep it from the network");
    return open;
}

}  // namespace chiaro::helper
