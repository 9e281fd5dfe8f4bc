#include "importer/base/limited_rights.hpp"
#include "importer/base/watched_process.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/support/programs.hpp"

#include <fcntl.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

namespace wakesurf::importer::limited_rights_test {
namespace {

// Runs a check in a process with limited rights, which are for good. Its exit status is what the check returns.
template <class Check>
int limited(const LimitedRights& rights, const Check& check) {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(limit_rights(rights).has_value() ? check() : 99);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

long landlock_version() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1);
}

TEST(LimitedRights, LeaveNoNetworkAndNoOtherPrograms) {
    EXPECT_EQ(limited({},
                      [] {
                          return ::socket(AF_INET, SOCK_STREAM, 0) < 0 && errno == EPERM &&
                                         ::socket(AF_UNIX, SOCK_STREAM, 0) < 0 && errno == EPERM
                                     ? 0
                                     : 1;
                      }),
              0);
    EXPECT_EQ(limited({},
                      [] {
                          ::execl("/bin/true", "true", nullptr);
                          return errno == EPERM ? 0 : 1;
                      }),
              0);
    EXPECT_EQ(limited({},
                      [] {
                          rlimit core{1, 1};
                          ::getrlimit(RLIMIT_CORE, &core);
                          return core.rlim_cur == 0 && core.rlim_max == 0 ? 0 : 1;
                      }),
              0);
}

TEST(LimitedRights, LeaveTheStoreAsTheOnlyPlaceToWriteTo) {
    if (landlock_version() < 1)
        GTEST_SKIP() << "this kernel has no Landlock";
    const TemporaryFolder folder;
    write_file(folder / "source", "data");
    const std::string outside = folder / "new";
    const std::string source = folder / "source";
    const std::string inside = folder / "store" / "new";
    EXPECT_EQ(limited({folder / "store", {folder / "source"}},
                      [&] {
                          const bool refused =
                              ::open(outside.c_str(), O_WRONLY | O_CREAT, 0644) < 0 &&
                              ::open(source.c_str(), O_WRONLY) < 0 && ::unlink(source.c_str()) != 0;
                          const bool allowed =
                              ::open(source.c_str(), O_RDONLY) >= 0 &&
                              ::open(inside.c_str(), O_WRONLY | O_CREAT, 0644) >= 0 &&
                              ::unlink(inside.c_str()) == 0;
                          return (refused ? 0 : 1) + (allowed ? 0 : 2);
                      }),
              0);
}

// Returns whether files are readable with limited rights: 1 each that is, from the first on.
int readable(const LimitedRights& rights, const std::vector<fs::path>& files) {
    return limited(rights, [&] {
        int out = 0;
        for (std::size_t i = 0; i < files.size(); ++i)
            out |= ::open(files[i].c_str(), O_RDONLY) >= 0 ? 1 << i : 0;
        return out;
    });
}

TEST(LimitedRights, LeaveTheSourceAsTheOnlyPlaceToReadFrom) {
    if (landlock_version() < 1)
        GTEST_SKIP() << "this kernel has no Landlock";
    const TemporaryFolder folder;
    fs::create_directories(folder / "source/inner");
    fs::create_directories(folder / "other");
    write_file(folder / "source/inner/file", "data");
    write_file(folder / "other/file", "secret");
    fs::create_symlink(folder / "other/file", folder / "source/link");
    const std::vector<fs::path> files{folder / "source/inner/file", folder / "other/file",
                                      folder / "source/link", folder / "other"};
    EXPECT_EQ(readable({{}, {folder / "source"}}, files), 1);
    EXPECT_EQ(readable({{}, {folder / "source/inner/file"}}, files), 1);
    EXPECT_EQ(readable({}, files), 0);
    EXPECT_EQ(readable({{}, {"/"}}, files), 15);
}

TEST(LimitedRights, LeaveNoSecretToRead) {
    if (landlock_version() < 1)
        GTEST_SKIP() << "this kernel has no Landlock";
    const TemporaryFolder folder;
    fs::create_directories(folder / "state");
    fs::create_directories(folder / "stated");
    write_file(folder / "state/token", "secret");
    write_file(folder / "stated/file", "data");
    write_file(folder / "file", "data");
    fs::create_symlink(folder / "state/token", folder / "link");
    fs::create_symlink("state", folder / "alias");
    const std::vector<fs::path> files{folder / "file", folder / "stated/file",
                                      folder / "state/token", folder / "link"};
    for (const auto& secret : {folder / "state", folder / "state/token", folder / "alias"})
        for (const auto& source : {fs::path("/"), folder.path()})
            EXPECT_EQ(readable({{}, {source}, {secret}}, files), 3) << secret << source;
    EXPECT_EQ(readable({folder / "state/store", {"/"}, {folder / "state"}},
                       {folder / "state/token", folder / "state/store"}),
              2);
}

TEST(LimitedRights, LeaveOtherFilesAsTheyAre) {
    const TemporaryFolder folder;
    write_file(folder / "source", "data");
    const std::string source = folder / "source";
    EXPECT_EQ(limited({folder / "store"},
                      [&] {
                          return (::truncate(source.c_str(), 0) != 0 ? 0 : 1) +
                                 (::chmod(source.c_str(), 0777) != 0 ? 0 : 2) +
                                 (::chown(source.c_str(), 0, 0) != 0 ? 0 : 4);
                      }),
              0);
    EXPECT_EQ(read_file(source), "data");
}

TEST(LimitedRights, LeaveProcessesOutsideAlone) {
    if (landlock_version() < 6)
        GTEST_SKIP() << "this kernel's Landlock knows no signals";
    const pid_t outside = ::getpid();
    EXPECT_EQ(limited({}, [&] { return ::kill(outside, 0) != 0 && errno == EPERM ? 0 : 1; }), 0);
    EXPECT_EQ(limited({},
                      [] {
                          const pid_t own = ::fork();
                          if (own == 0)
                              ::pause();
                          const bool ended = ::kill(own, SIGKILL) == 0;
                          ::waitpid(own, nullptr, 0);
                          return ended ? 0 : 1;
                      }),
              0);
}

// Runs the importer where a system call fails with an error, as in a container that forbids it.
// Its lines go to a file beside the store.
Outcome imported_where_fails(int system_call,
                             int error,
                             const fs::path& store,
                             const fs::path& source = bundled,
                             const char* option = "--precision=single") {
    int ends[2];
    (void)::pipe2(ends, O_CLOEXEC);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDERR_FILENO);
        ::dup2(::open((store.string() + ".lines").c_str(), O_WRONLY | O_CREAT, 0600),
               STDOUT_FILENO);
        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ALLOW);
        const auto refuse = SCMP_ACT_ERRNO(static_cast<unsigned>(error));
        ::seccomp_rule_add(filter, refuse, system_call, 0);
        if (system_call == SCMP_SYS(seccomp)) // the other way to the same
            ::seccomp_rule_add(filter, refuse, SCMP_SYS(prctl), 1,
                               SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP));
        ::seccomp_load(filter);
        ::execl(tests::importer_program().c_str(), "wakesurf-import", source.c_str(), store.c_str(),
                option, nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    Outcome out;
    char letter = 0;
    while (::read(ends[0], &letter, 1) == 1)
        out.errors += letter;
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    out.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return out;
}

TEST(LimitedRights, AreGivenUpOrNothingIsRead) {
    const TemporaryFolder folder;
    const auto expect_refusal = [&](int system_call, int error, const char* what) {
        const auto outcome = imported_where_fails(system_call, error, folder / "store");
        EXPECT_EQ(outcome.status, 1) << what;
        EXPECT_NE(
            outcome.errors.find(std::string("cannot give up rights before reading files (") + what),
            std::string::npos)
            << outcome.errors;
        EXPECT_FALSE(fs::exists(folder / "store" / "store.json")) << what;
    };
    expect_refusal(SCMP_SYS(seccomp), EPERM, "seccomp");
    expect_refusal(SCMP_SYS(landlock_create_ruleset), EMFILE, "Landlock");
    if (landlock_version() > 0)
        expect_refusal(SCMP_SYS(landlock_restrict_self), EPERM, "Landlock");
}

TEST(LimitedRights, DoNotNeedAKernelWithLandlock) {
    const TemporaryFolder folder;
    const auto outcome =
        imported_where_fails(SCMP_SYS(landlock_create_ruleset), ENOSYS, folder / "store");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_NE(read_file(folder / "store.lines")
                  .find("this kernel has no Landlock: the process that reads the files could read "
                        "and write wherever you can"),
              std::string::npos);
}

TEST(LimitedRights, WithoutLandlockConfineNoFileOfHdf5) {
    const TemporaryFolder folder;
    for (const std::size_t before : {0, 512, 4096}) {
        write_file(folder / "flow.cgns",
                   std::string(before, ' ') + std::string("\x89HDF\r\n\x1a\n") + "rest");
        const auto outcome =
            imported_where_fails(SCMP_SYS(landlock_create_ruleset), ENOSYS, folder / "store",
                                 folder / "flow.cgns", "--confined");
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.errors.find("flow.cgns is a file, which may link to other files"),
                  std::string::npos)
            << outcome.errors;
    }
}

TEST(LimitedRights, HoldWhileAnImportRuns) {
    const TemporaryFolder folder;
    const std::string store = folder / "store";
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::dup2(ends[1], STDERR_FILENO);
        ::execl(tests::importer_program().c_str(), "wakesurf-import", bundled.c_str(),
                store.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    char first = 0;
    ASSERT_EQ(::read(ends[0], &first, 1), 1);    // the first time-step is written
    const auto reading = processes_below(child); // the one that watches them reads no file
    std::string text;
    for (const pid_t process : reading) {
        ::kill(process, SIGSTOP);
        std::ifstream status("/proc/" + std::to_string(process) + "/status");
        text = {std::istreambuf_iterator<char>(status), {}};
        break;
    }
    for (const pid_t process : reading)
        ::kill(process, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    EXPECT_NE(text.find("Seccomp:\t2"), std::string::npos) << text;
    EXPECT_NE(text.find("NoNewPrivs:\t1"), std::string::npos) << text;
}

} // namespace
} // namespace wakesurf::importer::limited_rights_test
