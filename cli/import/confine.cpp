#include "cli/import/confine.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "base/sanitizers.h"

namespace lray::import {

namespace {

/// `grace`: how much more there is behind the signal of the limit, if it has one.
bool limit(int resource, std::uint64_t most, std::uint64_t grace = 0) {
    rlimit now{};
    if (getrlimit(static_cast<__rlimit_resource_t>(resource), &now) != 0) return false;
    const rlimit limits{std::min<rlim_t>(most, now.rlim_max),
                        std::min<rlim_t>(most + grace, now.rlim_max)};
    return setrlimit(static_cast<__rlimit_resource_t>(resource), &limits) == 0;
}

bool set_limits(std::uint64_t max_bytes, std::uint64_t max_seconds) {
    const bool is_memory_limited = kReservesTerabytes || limit(RLIMIT_AS, max_bytes);
    // At the harder limit the kernel kills, which would look like a crash: SIGXCPU comes first.
    constexpr std::uint64_t kGraceSeconds = 1;
    return is_memory_limited && limit(RLIMIT_CPU, max_seconds, kGraceSeconds) &&
           limit(RLIMIT_FSIZE, 0) && limit(RLIMIT_NOFILE, 0) && limit(RLIMIT_CORE, 0) &&
           limit(RLIMIT_NPROC, 0);
}

/// Closes all but the standard streams.
void close_others() {
    constexpr unsigned kFirst = STDERR_FILENO + 1;
    if (syscall(SYS_close_range, kFirst, ~0u, 0u) == 0) return;
    rlimit most{};
    getrlimit(RLIMIT_NOFILE, &most);
    constexpr rlim_t kReasonable = 1u << 16;  // where there is no such call limits are small
    for (rlim_t fd = kFirst; fd < std::min(most.rlim_cur, kReasonable); ++fd) {
        close(static_cast<int>(fd));
    }
}

/// Forbids all access to files by their names, of systems that have Landlock (Linux 5.13).
void leave_file_system() {
    landlock_ruleset_attr rules{};
    rules.handled_access_fs =
        LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
        LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR |
        LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
        LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK |
        LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
    const auto ruleset =
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0));
    if (ruleset < 0) return;
    syscall(SYS_landlock_restrict_self, ruleset, 0);
    close(ruleset);
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

constexpr sock_filter load(std::size_t offset) {
    return {BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)};
}
constexpr sock_filter give(std::uint32_t what) {
    return {BPF_RET | BPF_K, 0, 0, what};
}
/// Skips the next `count` unless the loaded value is this one.
constexpr sock_filter unless(std::uint32_t value, std::uint8_t count) {
    return {BPF_JMP | BPF_JEQ | BPF_K, 0, count, value};
}

/// Lets only these calls through, of systems that have seccomp.
void leave_system_calls() {
    if constexpr (kArchitecture == 0) return;
    std::vector<sock_filter> filter = {
        load(offsetof(seccomp_data, arch)), unless(kArchitecture, 1),
        {BPF_JMP | BPF_JA, 0, 0, 1},        give(SECCOMP_RET_KILL_PROCESS),
        load(offsetof(seccomp_data, nr)),
    };
    for (const long call :
         {SYS_read,        SYS_write,         SYS_munmap,         SYS_mremap,
          SYS_brk,         SYS_madvise,       SYS_futex,          SYS_exit,
          SYS_exit_group,  SYS_rt_sigreturn,  SYS_rt_sigprocmask, SYS_rt_sigaction,
          SYS_sigaltstack, SYS_clock_gettime, SYS_gettimeofday,   SYS_getrandom,
          SYS_sched_yield, SYS_getpid,        SYS_gettid,         SYS_lseek,
          SYS_fstat,       SYS_close}) {
        filter.push_back(unless(static_cast<std::uint32_t>(call), 1));
        filter.push_back(give(SECCOMP_RET_ALLOW));
    }
    // Looking for a file is what libraries may do by habit; it finds none.
    for (const long call : {
             SYS_openat, SYS_newfstatat, SYS_faccessat, SYS_readlinkat, SYS_statx,
#if defined(__x86_64__)
                 SYS_open, SYS_stat, SYS_lstat, SYS_access, SYS_readlink,
#endif
         }) {
        filter.push_back(unless(static_cast<std::uint32_t>(call), 1));
        filter.push_back(give(SECCOMP_RET_ERRNO | EACCES));
    }
    // Ending itself, by a signal to itself.
    filter.push_back(unless(SYS_tgkill, 3));
    filter.push_back(load(offsetof(seccomp_data, args[0])));
    filter.push_back(unless(static_cast<std::uint32_t>(getpid()), 1));
    filter.push_back(give(SECCOMP_RET_ALLOW));
    filter.push_back(load(offsetof(seccomp_data, nr)));
    // Memory that can be executed is new code.
    for (const long call : {SYS_mmap, SYS_mprotect}) {
        filter.push_back(unless(static_cast<std::uint32_t>(call), 4));
        filter.push_back(load(offsetof(seccomp_data, args[2])));
        filter.push_back({BPF_JMP | BPF_JSET | BPF_K, 1, 0, PROT_EXEC});
        filter.push_back(give(SECCOMP_RET_ALLOW));
        filter.push_back(give(SECCOMP_RET_KILL_PROCESS));
    }
    filter.push_back(give(SECCOMP_RET_KILL_PROCESS));
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
}

}  // namespace

bool confine(std::uint64_t max_bytes, std::uint64_t max_seconds) {
    close_others();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 0);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    leave_file_system();  // takes a descriptor for a moment
    if (!set_limits(max_bytes, max_seconds)) return false;
    leave_system_calls();
    return true;
}

}  // namespace lray::import
