// What the process that watches an import bounds: the memory of all its processes, the time for a survey and without progress,
// and how its end is told.
#include "importer/base/reading_bounds.hpp"
#include "importer/base/watched_process.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <new>
#include <vector>

namespace wakesurf::importer::watched_process_test {
namespace {

using core::Error;
using std::chrono::seconds;
using tests::TemporaryFolder;

constexpr std::size_t mebi = std::size_t{1} << 20;
constexpr ImportBounds plenty{std::uint64_t{4} << 30, seconds(60), seconds(60)};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t scale = 8; // the sanitizers' own memory counts as well
#else
constexpr std::size_t scale = 1;
#endif

// Memory that is really taken, as long as the process.
void* taken(std::size_t bytes) {
    void* const memory =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    std::memset(memory, 1, bytes);
    return memory;
}

[[noreturn]] void wait_to_be_ended() {
    for (;;)
        ::pause();
}

[[noreturn]] void find_no_memory() {
    throw std::bad_alloc();
}

template <class Body>
pid_t forked(const Body& body) {
    const pid_t process = ::fork();
    if (process == 0) {
        body();
        ::_exit(0);
    }
    return process;
}

bool lives(pid_t process) {
    return ::kill(process, 0) == 0;
}

/// The memory that this process holds, in bytes: the second number of /proc/self/statm, in pages.
std::uint64_t resident() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t size = 0, pages = 0;
    statm >> size >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

TEST(WatchedProcess, ReturnsWhatItsWorkReturns) {
    EXPECT_EQ(run_watched("a.vti", plenty, [] { return 0; }).value(), 0);
    EXPECT_EQ(run_watched("a.vti", plenty, [] { return 7; }).value(), 7);
}

TEST(WatchedProcess, SumsTheMemoryOfAllProcessesOfAnImport) {
    const TemporaryFolder folder;
    const std::string list = folder / "processes";
    const auto ended = run_watched("a.vti", {100 * scale * mebi, seconds(60), seconds(60)}, [&] {
        for (int i = 0; i < 2; ++i) { // neither takes too much alone
            const pid_t process = forked([] {
                taken(70 * scale * mebi);
                wait_to_be_ended();
            });
            std::ofstream(list, std::ios::app) << process << "\n";
        }
        wait_to_be_ended();
        return 0;
    });
    ASSERT_FALSE(ended.has_value());
    EXPECT_EQ(ended.error().code, Error::Code::OverLimit);
    EXPECT_EQ(ended.error().limit, 100 * scale * mebi);
    EXPECT_EQ(ended.error().message.find("a.vti needs too much memory: an import may take "), 0u);
    EXPECT_NE(ended.error().hint.find("--memory SIZE"), std::string::npos);
    std::ifstream in(list);
    int found = 0;
    for (pid_t process = 0; in >> process; ++found)
        EXPECT_FALSE(lives(process)) << "a worker is left";
    EXPECT_EQ(found, 2);
}

TEST(WatchedProcess, CountsMemoryThatProcessesShareOnce) {
    // The import begins with what tests before have left in this process.
    const std::uint64_t limit = resident() + 140 * scale * mebi;
    const auto ended = run_watched("a.vti", {limit, seconds(60), seconds(60)}, [] {
        taken(90 * scale * mebi); // the plan and the first time-step, which the workers share
        std::vector<pid_t> workers;
        for (int i = 0; i < 3; ++i)
            workers.push_back(forked([] { ::usleep(300'000); }));
        for (const pid_t worker : workers)
            ::waitpid(worker, nullptr, 0);
        return 3;
    });
    EXPECT_EQ(ended.value_or(-1), 3) << (ended ? "" : ended.error().message);
}

TEST(WatchedProcess, CountsMemoryThatNoAllocatorKnows) {
    const auto ended = run_watched("a.vti", {100 * scale * mebi, seconds(60), seconds(60)}, [] {
        const std::size_t bytes = 200 * scale * mebi;
        void* const memory =
            ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        std::memset(memory, 1, bytes);
        wait_to_be_ended();
        return 0;
    });
    EXPECT_EQ(ended.error().code, Error::Code::OverLimit);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(WatchedProcess, RefusesNonsenseBeforeMemoryIsFilled) {
    const auto ended = run_watched("a.vti", {100 * mebi, seconds(60), seconds(60)}, [] {
        try {
            const std::vector<char> nonsense(std::size_t{64} << 30);
        } catch (const std::bad_alloc&) {
            return progress_marks().out_of_memory ? 5 : 6;
        }
        return 0;
    });
    EXPECT_EQ(ended.value_or(-1), 5);
}
#endif

TEST(WatchedProcess, TellsAnEndForWantOfMemoryFromACrash) {
    const auto wanting = run_watched("a.vti", plenty, []() -> int {
        const auto out_of_memory = []() noexcept { find_no_memory(); }; // as through C code
        out_of_memory();
        return 0;
    });
    EXPECT_EQ(wanting.error().code, Error::Code::OverLimit);
    const auto crashed = run_watched("a.vti", plenty, [] {
        ::signal(SIGSEGV, SIG_DFL);
        ::raise(SIGSEGV);
        return 0;
    });
    EXPECT_EQ(crashed.error().code, Error::Code::Corrupt);
    EXPECT_EQ(crashed.error().message, "the library that reads a.vti crashed (signal 11)");
}

TEST(WatchedProcess, EndsASurveyThatHangs) {
    const auto ended = run_watched("a.vti", {plenty.memory, seconds(1), seconds(60)}, [] {
        wait_to_be_ended();
        return 0;
    });
    EXPECT_EQ(ended.error().message, "the contents of a.vti were not clear after 1 s");
    EXPECT_NE(ended.error().hint.find("--survey"), std::string::npos);
}

TEST(WatchedProcess, EndsAnImportWithoutProgress) {
    const auto ended = run_watched("a.vti", {plenty.memory, seconds(60), seconds(1)}, [] {
        progress_marks().surveyed = true;
        wait_to_be_ended();
        return 0;
    });
    EXPECT_EQ(ended.error().message, "no progress for 1 s, longer than --stall allows");
}

TEST(WatchedProcess, EndsItsProcessesWhenItIsInterruptedOrKilled) {
    for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
        int ends[2];
        ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
        const pid_t watching = forked([&] {
            const auto ended = run_watched("a.vti", plenty, [&] {
                const pid_t own = ::getpid();
                (void)!::write(ends[1], &own, sizeof(own));
                wait_to_be_ended();
                return 0;
            });
            ::_exit(!ended && ended.error().code == Error::Code::Cancelled ? 42 : 1);
        });
        pid_t worker = 0;
        ASSERT_EQ(::read(ends[0], &worker, sizeof(worker)), static_cast<ssize_t>(sizeof(worker)));
        ::close(ends[1]);
        ::kill(watching, signal);
        int status = 0;
        ::waitpid(watching, &status, 0);
        EXPECT_TRUE(signal == SIGKILL ? WIFSIGNALED(status) : WEXITSTATUS(status) == 42);
        char nothing = 0;
        EXPECT_EQ(::read(ends[0], &nothing, 1), 0) << "the worker has the pipe until it has ended";
        ::close(ends[0]);
    }
}

TEST(ProcessMemory, IsWhatAProcessReallyTakes) {
    const pid_t other = forked([] {
        taken(64 * mebi);
        wait_to_be_ended();
    });
    const auto enough = [&] { return exact_memory({other}) >= 64 * mebi; };
    for (int i = 0; i < 2000 && !enough(); ++i)
        ::usleep(5000);
    EXPECT_TRUE(enough());
    EXPECT_LE(exact_memory({other}), quick_memory({other}));
    const auto below = processes_below(::getpid());
    EXPECT_NE(std::find(below.begin(), below.end(), other), below.end());
    ::kill(other, SIGKILL);
    ::waitpid(other, nullptr, 0);
    EXPECT_EQ(quick_memory({other}), 0u);
}

} // namespace
} // namespace wakesurf::importer::watched_process_test
