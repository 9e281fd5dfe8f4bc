#include "server/import/limited_rights.hpp"
#include "tests/server/import/import_fixture.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

namespace wakesurf::server {
namespace {

// Runs a check in a process with limited rights, which are for good. Its exit status is what the check returns.
template <class Check>
int limited(const LimitedRights& rights, const Check& check) {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(limit_rights(rights) ? check() : 99);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool has_landlock() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1) > 0; // asks for its version
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
    if (!has_landlock())
        GTEST_SKIP() << "this kernel has no Landlock";
    const TemporaryFolder folder;
    write_file(folder / "source", "data");
    const std::string outside = folder / "new";
    const std::string source = folder / "source";
    const std::string inside = folder / "store" / "new";
    EXPECT_EQ(limited({folder / "store"},
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

TEST(LimitedRights, EndAProcessThatMakesNoProgress) {
    EXPECT_EQ(limited({std::nullopt, std::chrono::seconds(1)},
                      [] {
                          ::pause();
                          return 0;
                      }),
              -SIGALRM);
}

TEST(LimitedRights, HoldWhileAnImportRuns) {
    const TemporaryFolder folder;
    const std::string store = folder / "store";
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::execl(WAKESURF_IMPORT_BINARY, "wakesurf-import", bundled.c_str(), store.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    char first = 0;
    ASSERT_EQ(::read(ends[0], &first, 1), 1); // the first time-step is written
    ::kill(child, SIGSTOP);
    std::ifstream status("/proc/" + std::to_string(child) + "/status");
    std::string text{std::istreambuf_iterator<char>(status), {}};
    ::kill(child, SIGCONT);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    EXPECT_NE(text.find("Seccomp:\t2"), std::string::npos) << text;
    EXPECT_NE(text.find("NoNewPrivs:\t1"), std::string::npos) << text;
}

} // namespace
} // namespace wakesurf::server
