#include "importer/base/watched_process.hpp"

#include "core/base/machine_memory.hpp"
#include "importer/base/reading_bounds.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::importer {

using core::Error;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

namespace {

// The poll interval. A process fills some 2 GB/s: memory may exceed the bound by 20 MB before that is seen.
constexpr std::chrono::milliseconds poll_interval{10};

// Reading so many bytes counts as progress: values of a large first time-step are part of the survey.
constexpr std::uint64_t bytes_of_progress = std::uint64_t{16} << 20;

fs::path shown(pid_t process, std::string_view file) {
    return fs::path("/proc") / std::to_string(process) / file;
}

// Returns the sum of lines "Name:   123 kB" in bytes; 0 for a missing file: the process has ended.
std::uint64_t kilobytes_in(const fs::path& file, std::initializer_list<std::string_view> names) {
    std::ifstream in(file);
    std::uint64_t sum = 0;
    for (std::string line; std::getline(in, line);)
        for (const auto name : names)
            if (line.starts_with(name))
                sum += std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
    return sum;
}

void add_below(pid_t process, std::vector<pid_t>& found) {
    std::error_code gone;
    for (fs::directory_iterator thread(shown(process, "task"), gone), end; !gone && thread != end;
         thread.increment(gone)) {
        std::ifstream in(thread->path() / "children");
        for (pid_t child = 0; in >> child;) {
            found.push_back(child);
            add_below(child, found);
        }
    }
}

// The bytes that a process has read from files and pipes; 0 if the system does not say.
std::uint64_t bytes_read_by(pid_t process) {
    std::ifstream in(shown(process, "io"));
    std::string name;
    std::uint64_t bytes = 0;
    return in >> name >> bytes && name == "rchar:" ? bytes : 0;
}

std::string size_text(std::uint64_t bytes) {
    char text[32];
    const double mebi = static_cast<double>(bytes) / 0x1p20;
    if (mebi < 1024.0)
        std::snprintf(text, sizeof(text), "%.0f MiB", mebi);
    else
        std::snprintf(text, sizeof(text), "%.1f GiB", mebi / 1024.0);
    return text;
}

// Bounds the addresses of each process as well: a nonsensical size fails when it is requested, before memory
// is filled. The bound is twice as high, since requested memory need not be used.
void bound_addresses(std::uint64_t memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    (void)memory; // the sanitizers' shadow memory takes terabytes of addresses
#else
    rlimit now{};
    ::getrlimit(RLIMIT_AS, &now);
    constexpr rlim_t libraries = rlim_t{2} << 30;
    constexpr rlim_t largest = rlim_t{1} << 60; // twice that is still a number
    const rlim_t most =
        std::min<rlim_t>(now.rlim_max, 2 * std::min<rlim_t>(memory, largest) + libraries);
    const rlimit space{most, most};
    ::setrlimit(RLIMIT_AS, &space);
#endif
}

void out_of_memory() {
    progress_marks().out_of_memory = true;
    throw std::bad_alloc();
}

// Ends the process when an exception meets C code on its way.
void report_and_abort() {
    try {
        if (std::current_exception())
            std::rethrow_exception(std::current_exception());
    } catch (const std::bad_alloc&) {
        progress_marks().out_of_memory = true;
    } catch (...) {
    }
    std::abort();
}

sigset_t signals_of(std::initializer_list<int> list) {
    sigset_t set;
    ::sigemptyset(&set);
    for (const int signal : list)
        ::sigaddset(&set, signal);
    return set;
}

// Error: Unsupported if the system does not show processes and their memory (no /proc).
core::Result<void> check_processes_show() {
    const pid_t own = ::getpid();
    std::error_code error;
    const auto children = shown(own, "task") / std::to_string(own) / "children";
    if (fs::exists(children, error) && quick_memory({own}) > 0)
        return {};
    return core::fail(core::Error::Code::Unsupported,
                      "this system does not show the memory of processes",
                      "mount /proc, and use a kernel with /proc/PID/task/TID/children");
}

class Watch {
  public:
    Watch(pid_t process, const std::string& source, const ImportBounds& bounds)
        : process_(process), source_(source), bounds_(bounds) {}

    core::Result<int> until_end(const sigset_t& signals) {
        const auto every = timespec{
            0, std::chrono::duration_cast<std::chrono::nanoseconds>(poll_interval).count()};
        for (;;) {
            const int signal = ::sigtimedwait(&signals, nullptr, &every);
            if (signal == SIGINT || signal == SIGTERM)
                return interrupted();
            if (const auto ended = reap())
                return outcome(*ended);
            if (auto within = check_bounds(); !within)
                return tl::unexpected(give_up(within.error()));
        }
    }

  private:
    // Reaps children, and processes whose parent has ended, which are children of this one then.
    std::optional<int> reap() {
        std::optional<int> ended;
        int status = 0;
        for (pid_t gone = 0; (gone = ::waitpid(-1, &status, WNOHANG)) > 0;)
            if (gone == process_)
                ended = status;
        return ended;
    }

    core::Result<int> outcome(int status) const {
        if (WIFEXITED(status))
            return WEXITSTATUS(status);
        if (progress_marks().out_of_memory)
            return tl::unexpected(too_large());
        return core::fail(Error::Code::Corrupt,
                          "the library that reads " + source_ + " crashed (signal " +
                              std::to_string(WTERMSIG(status)) + ")",
                          "the library cannot handle something in the file, which need not be "
                          "damaged; try to convert it with another program first");
    }

    core::Result<int> interrupted() {
        ::kill(process_, SIGTERM);
        constexpr std::chrono::seconds patience{1};
        const auto begun = Clock::now();
        while (!reap() && Clock::now() - begun < patience)
            ::usleep(2000);
        return tl::unexpected(give_up(
            {Error::Code::Cancelled, "interrupted", "run the same command again to resume"}));
    }

    Error too_large() const {
        return with_memory_bound({Error::Code::OverLimit, source_ + " needs too much memory", {}},
                                 bounds_.memory);
    }

    Error give_up(Error why) {
        for (auto left = processes_below(::getpid()); !left.empty();
             left = processes_below(::getpid())) {
            for (const pid_t process : left)
                ::kill(process, SIGKILL);
            reap();
            ::usleep(1000);
        }
        return why;
    }

    core::Result<void> check_bounds() {
        if (over_bound())
            return tl::unexpected(too_large());
        const auto now = Clock::now();
        const ProgressMarks& marks = progress_marks();
        const bool surveyed = marks.surveyed;
        if (const auto progress = marks.progress.load();
            progress != progress_ || surveyed != surveyed_) {
            progress_ = progress;
            surveyed_ = surveyed;
            since_ = now;
        }
        const auto most = surveyed ? bounds_.stall : bounds_.survey;
        if (most == most.zero() || now - since_ < most)
            return {};
        if (const auto read = bytes_read_by(process_); read >= read_ + bytes_of_progress) {
            read_ = read;
            since_ = now;
            return {};
        }
        const std::string seconds = std::to_string(most.count()) + " s";
        if (!surveyed)
            return core::fail(Error::Code::Io,
                              "the contents of " + source_ + " were not clear after " + seconds,
                              "it is probably damaged; wakesurf-import --survey SECONDS allows "
                              "more for a slow disk");
        return core::fail(Error::Code::Io,
                          "no progress for " + seconds + ", longer than --stall allows",
                          "run the same command again to resume");
    }

    bool over_bound() {
        const auto processes = processes_below(::getpid());
        if (quick_memory(processes) <= bounds_.memory || Clock::now() < exact_again_)
            return false;
        const auto begun = Clock::now();
        if (exact_memory(processes) > bounds_.memory)
            return true;
        const auto took = Clock::now() - begun;
        exact_again_ = Clock::now() + 9 * took; // a tenth of the time at most
        return false;
    }

    pid_t process_;
    const std::string& source_;
    const ImportBounds& bounds_;
    std::uint64_t progress_ = 0;
    bool surveyed_ = false;
    std::uint64_t read_ = 0;
    Clock::time_point since_ = Clock::now();
    Clock::time_point exact_again_{};
};

} // namespace

std::vector<pid_t> processes_below(pid_t process) {
    std::vector<pid_t> found;
    add_below(process, found);
    return found;
}

std::uint64_t quick_memory(const std::vector<pid_t>& processes) {
    std::uint64_t sum = 0;
    for (const pid_t process : processes)
        sum += kilobytes_in(shown(process, "status"), {"RssAnon:", "RssShmem:"});
    return sum;
}

std::uint64_t exact_memory(const std::vector<pid_t>& processes) {
    std::uint64_t sum = 0;
    for (const pid_t process : processes)
        sum += kilobytes_in(shown(process, "smaps_rollup"), {"Pss_Anon:", "Pss_Shmem:"});
    return sum > 0 ? sum : quick_memory(processes); // before Linux 5.4
}

std::uint64_t usual_import_memory() {
    constexpr std::uint64_t where_unknown = std::uint64_t{1} << 30;
    const auto granted = core::granted_memory();
    return granted > 0 ? granted / 4 : where_unknown;
}

Error with_memory_bound(Error error, std::uint64_t bound) {
    error.message += ": an import may take " + size_text(bound);
    error.hint =
        "import it with --memory SIZE for more, or with fewer --jobs; a small file that needs "
        "that much is damaged" +
        (error.hint.empty() ? "" : "; " + error.hint);
    error.limit = bound;
    return error;
}

// The kernel reports a parent's end only from here on: after an earlier end this process has another parent.
bool end_with(int parent) {
    return ::prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && ::getppid() == parent;
}

core::Result<int> run_watched(const std::string& source,
                              const ImportBounds& bounds,
                              const std::function<int()>& work) {
    if (auto shown = check_processes_show(); !shown)
        return tl::unexpected(shown.error());
    ProgressMarks& marks = progress_marks();
    marks.surveyed = false;
    marks.out_of_memory = false;
    const auto signals = signals_of({SIGINT, SIGTERM, SIGCHLD});
    sigset_t before;
    ::signal(SIGCHLD,
             SIG_DFL); // the parent may have ignored it: then no process could be waited for
    ::sigprocmask(SIG_BLOCK, &signals, &before);
    // Processes whose parent has ended stay below this one, so that they count and can be ended.
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t own = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != own)
            ::_exit(1);
        ::sigprocmask(SIG_SETMASK, &before, nullptr);
        bound_addresses(bounds.memory);
        set_memory_bound(bounds.memory);
        std::set_new_handler(out_of_memory);
        std::set_terminate(report_and_abort);
        const int status = work();
        std::fflush(nullptr);
        ::_exit(status);
    }
    core::Result<int> ended = core::fail(Error::Code::Io, "cannot start a process");
    if (process > 0)
        ended = Watch(process, source, bounds).until_end(signals);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    return ended;
}

} // namespace wakesurf::importer
