#include "importer/base/limited_rights.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

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

constexpr std::uint64_t read_rights = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t of_files = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;

// What libraries look for as they go on: the tables of characters and units, and others of their own.
constexpr std::array system_folders{"/usr", "/lib", "/lib64", "/proc", "/sys", "/dev"};

bool lies_in(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

fs::path real_path(const fs::path& path) {
    std::error_code error;
    return fs::weakly_canonical(path, error);
}

/// The files that a process may use: rules of Landlock only ever allow.
class Rules {
  public:
    explicit Rules(int rules) : rules_(rules) {}

    ~Rules() { ::close(rules_); }

    Rules(const Rules&) = delete;
    Rules& operator=(const Rules&) = delete;

    /// Allows it for a file, or a folder and all below. What cannot be opened is left out: who needs it says so.
    core::Result<void> allow(const fs::path& path, std::uint64_t access) {
        const int opened = ::open(path.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW);
        if (opened < 0)
            return {};

        struct stat status {};

        ::fstat(opened, &status);
        const landlock_path_beneath_attr rule{S_ISDIR(status.st_mode) ? access : access & of_files,
                                              opened};
        const bool allowed =
            S_ISLNK(status.st_mode) || // the rule for what it leads to counts
            ::syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
        const int error = errno;
        ::close(opened);
        return allowed ? core::Result<void>() : cannot("Landlock", error);
    }

    /// Allows reading all but the secrets. A folder that holds one may be listed, and each other entry that it
    /// has now may be read; if it may not be listed, none of them.
    core::Result<void> allow_reading(const fs::path& path, const std::vector<fs::path>& secrets) {
        const auto holds = [&](const fs::path& secret) { return lies_in(secret, path); };
        if (std::ranges::none_of(secrets, holds))
            return allow(path, read_rights);
        if (std::ranges::find(secrets, path) != secrets.end())
            return {};
        auto done = allow(path, LANDLOCK_ACCESS_FS_READ_DIR);
        std::error_code error;
        for (fs::directory_iterator entry(path, error), end; done && !error && entry != end;
             entry.increment(error))
            done = allow_reading(entry->path(), secrets);
        return done;
    }

    core::Result<void> restrict_this_process() const {
        return ::syscall(SYS_landlock_restrict_self, rules_, 0) == 0 ? core::Result<void>()
                                                                     : cannot("Landlock", errno);
    }

  private:
    int rules_;
};

core::Result<void> limit_files(const LimitedRights& rights) {
    const auto version =
        ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 0 && (errno == ENOSYS || errno == EOPNOTSUPP))
        return {}; // without Landlock in this kernel, or with it switched off
    if (version < 0)
        return cannot("Landlock", errno);
    const Ruleset handled{read_rights | writing, 0,
                          version >= 6 ? abstract_sockets_and_signals : 0};
    const std::size_t known = version >= 6 ? sizeof(handled) : sizeof(handled.files);
    const auto opened =
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, known, 0));
    if (opened < 0)
        return cannot("Landlock", errno);
    Rules rules(opened);
    core::Result<void> done;
    if (rights.store) {
        std::error_code reported_by_the_writer;
        fs::create_directories(*rights.store, reported_by_the_writer);
        // A store that cannot be made or opened is reported by the writer, which may then write nowhere.
        done = rules.allow(real_path(*rights.store), read_rights | writing);
    }
    std::vector<fs::path> secrets;
    for (const auto& secret : rights.secrets)
        secrets.push_back(real_path(secret));
    std::vector<fs::path> readable(system_folders.begin(), system_folders.end());
    readable.insert(readable.end(), rights.sources.begin(), rights.sources.end());
    for (const auto& path : readable)
        if (done)
            done = rules.allow_reading(real_path(path), secrets);
    return done.and_then([&] { return rules.restrict_this_process(); });
}

} // namespace

core::Result<void> limit_rights(const LimitedRights& rights) {
    const rlimit none{0, 0};
    if (::setrlimit(RLIMIT_CORE, &none) != 0) // a core file would hold what was read
        return cannot("core files", errno);
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return cannot("new privileges", errno);
    return limit_files(rights).and_then([] { return limit_system_calls(); });
}

bool kernel_has_landlock() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

} // namespace wakesurf::importer
