#include "importer/base/limited_rights.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>

namespace wakesurf::importer {

using core::Error;

namespace {

constexpr std::array denied{SCMP_SYS(socket),
                            SCMP_SYS(socketpair),
                            SCMP_SYS(connect),
                            SCMP_SYS(bind),
                            SCMP_SYS(listen),
                            SCMP_SYS(accept),
                            SCMP_SYS(accept4),
                            SCMP_SYS(execve),
                            SCMP_SYS(execveat),
                            SCMP_SYS(ptrace),
                            SCMP_SYS(process_vm_readv),
                            SCMP_SYS(process_vm_writev),
                            SCMP_SYS(mount),
                            SCMP_SYS(umount2),
                            SCMP_SYS(pivot_root),
                            SCMP_SYS(chroot),
                            SCMP_SYS(unshare),
                            SCMP_SYS(setns),
                            SCMP_SYS(bpf),
                            SCMP_SYS(perf_event_open),
                            SCMP_SYS(userfaultfd),
                            SCMP_SYS(io_uring_setup),
                            SCMP_SYS(keyctl),
                            SCMP_SYS(add_key),
                            SCMP_SYS(request_key),
                            SCMP_SYS(init_module),
                            SCMP_SYS(finit_module),
                            SCMP_SYS(delete_module),
                            SCMP_SYS(kexec_load),
                            SCMP_SYS(reboot),
                            SCMP_SYS(open_by_handle_at),
                            SCMP_SYS(swapon),
                            SCMP_SYS(swapoff),
                            SCMP_SYS(settimeofday),
                            SCMP_SYS(clock_settime),
                            SCMP_SYS(sethostname)};

// System calls on files by name that Landlock does not cover, or only in newer versions.
constexpr std::array denied_by_name{
    SCMP_SYS(truncate),    SCMP_SYS(chmod),        SCMP_SYS(fchmodat),  SCMP_SYS(chown),
    SCMP_SYS(lchown),      SCMP_SYS(fchownat),     SCMP_SYS(setxattr),  SCMP_SYS(lsetxattr),
    SCMP_SYS(removexattr), SCMP_SYS(lremovexattr), SCMP_SYS(utimensat), SCMP_SYS(mknod),
    SCMP_SYS(mknodat)};

core::Result<void> cannot(const char* what, int error) {
    return core::fail(Error::Code::Io,
                      std::string("cannot give up rights before reading files (") + what + ": " +
                          std::generic_category().message(error) + ")",
                      "run it where seccomp filters and Landlock are allowed; untrusted files are "
                      "not read without them");
}

core::Result<void> limit_system_calls() {
    scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ALLOW);
    if (filter == nullptr)
        return cannot("seccomp", ENOMEM);
    int error = 0;
    const auto deny = [&](int call) {
        if (error == 0)
            error = -::seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0);
    };
    std::for_each(denied.begin(), denied.end(), deny);
    std::for_each(denied_by_name.begin(), denied_by_name.end(), deny);
    if (error == 0)
        error = -::seccomp_load(filter);
    ::seccomp_release(filter);
    return error == 0 ? core::Result<void>() : cannot("seccomp", error);
}

// Every right to change a file system that the first version of Landlock knows.
constexpr std::uint64_t writing = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                  LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                  LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                  LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                  LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

// The landlock_ruleset_attr of version 6 (Linux 6.12): headers may be older, and kernels take the part they
// know.
struct Ruleset {
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scoped = 0;
};

constexpr std::uint64_t abstract_sockets_and_signals = 3; // to processes that have more rights

core::Result<void> limit_writing(const LimitedRights& rights) {
    const auto version =
        ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 0 && (errno == ENOSYS || errno == EOPNOTSUPP))
        return {}; // without Landlock in this kernel, or with it switched off
    if (version < 0)
        return cannot("Landlock", errno);
    const Ruleset handled{writing, 0, version >= 6 ? abstract_sockets_and_signals : 0};
    const std::size_t known = version >= 6 ? sizeof(handled) : sizeof(handled.files);
    const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, known, 0));
    if (rules < 0)
        return cannot("Landlock", errno);
    core::Result<void> done;
    if (rights.store) {
        std::error_code told_by_the_writer;
        std::filesystem::create_directories(*rights.store, told_by_the_writer);
        const int opened = ::open(rights.store->c_str(), O_PATH | O_CLOEXEC);
        const landlock_path_beneath_attr rule{writing, opened};
        // A store that cannot be made or opened is reported by the writer, which may then write nowhere.
        if (opened >= 0 &&
            ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
            done = cannot("Landlock", errno);
        ::close(opened);
    }
    if (done && ::syscall(SYS_landlock_restrict_self, rules, 0) != 0)
        done = cannot("Landlock", errno);
    ::close(rules);
    return done;
}

} // namespace

core::Result<void> limit_rights(const LimitedRights& rights) {
    const rlimit none{0, 0};
    if (::setrlimit(RLIMIT_CORE, &none) != 0) // a core file would hold what was read
        return cannot("core files", errno);
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return cannot("new privileges", errno);
    return limit_writing(rights).and_then([] { return limit_system_calls(); });
}

bool kernel_has_landlock() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

} // namespace wakesurf::importer
