#include "server/data/bricks/bricks_job.hpp"

#include "server/base/log_text.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

extern char** environ;

namespace wakesurf::server {

using core::Error;
using core::Result;

Result<bool> JobKeeper::tend() {
    listen();
    const Time now = options_.wall().now();
    if (!job_)
        return now < next_start_ ? Result<bool>(false) : start().map([] { return false; });
    if (talk_)
        return false;
    if (auto came = let_in(); !came || *came)
        return came;
    if (job_->ended())
        return core::fail(Error::Code::Io, "the job ended before it connected",
                          "its own output is above");
    if (now - started_ >= options_.coming)
        return core::fail(Error::Code::Io, "the job has not connected in time");
    return false;
}

Result<void> JobKeeper::start() {
    auto opened = LocalDoor::open();
    if (!opened)
        return tl::unexpected(opened.error());
    door_.emplace(std::move(*opened));
    std::vector<std::string> words = options_.words;
    words.insert(words.end(), {options_.program.string(), options_.store.string(), "--socket",
                               door_->path().string()});
    if (options_.memory > 0)
        words.insert(words.end(), {"--memory", std::to_string(options_.memory)});
    auto begun = BricksJob::start(std::move(words));
    if (!begun)
        return tl::unexpected(begun.error());
    started_ = options_.wall().now();
    job_ = std::move(*begun);
    return {};
}

void JobKeeper::listen() {
    if (job_)
        for (const std::string& line : job_->lines())
            if (!line.empty())
                spdlog::info("event=bricks_job message={}", log_value(line));
}

Result<bool> JobKeeper::let_in() {
    if (!guest_)
        if (auto came = door_->let_in())
            guest_ = std::move(*came);
    if (!guest_)
        return false;
    auto met = JobTalk::meet(*guest_, wanted_);
    if (!met)
        return tl::unexpected(met.error());
    if (!*met)
        return false;
    guest_.reset();
    door_.reset(); // nobody else comes, and a server that is killed leaves nothing behind
    talk_ = std::move(**met);
    rest_ = options_.first_rest;
    spdlog::info("event=bricks_job_there ranks={} bricks={}", talk_->ranks(), talk_->held());
    return true;
}

void JobKeeper::end() {
    guest_.reset();
    talk_.reset(); // the job notices, and ends
    listen();
    job_.reset();
    door_.reset();
    next_start_ = options_.wall().now() + rest_;
    rest_ = std::min(2 * rest_, options_.longest_rest);
}

void JobKeeper::watch(std::vector<pollfd>& files) const {
    if (job_ && !job_->ended() && job_->output() >= 0)
        files.push_back({job_->output(), POLLIN, 0});
    if (talk_)
        files.push_back({talk_->socket(), POLLIN, 0});
    else if (guest_)
        files.push_back({guest_->get(), POLLIN, 0});
    else if (door_)
        files.push_back({door_->file(), POLLIN, 0});
}

JobKeeper::Time JobKeeper::due() const {
    return !job_ ? next_start_ : !talk_ ? started_ + options_.coming : Time::max();
}

using core::Error;

namespace {

constexpr std::size_t longest_word_line = 4096;
constexpr std::chrono::milliseconds look{10};
constexpr int polls_before_term = 100; // polls before it is asked to end: it may end by itself
constexpr int polls_before_kill = 200; // polls before it is killed

/// Starts the job in a process group of its own: a signal of the terminal goes to the server, which then ends
/// the job.
int spawn_job(pid_t& child, std::vector<std::string> words, int output) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    sigset_t none, usual;
    ::sigemptyset(&none);
    ::sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
        ::sigaddset(&usual, signal);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                                POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int problem =
        ::posix_spawnp(&child, arguments.front(), &actions, &attributes, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    return problem;
}

bool ends_within(pid_t process, int looks) {
    for (int i = 0; i < looks; ++i) {
        siginfo_t ended{};
        if (::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
            ended.si_pid == process)
            return true;
        std::this_thread::sleep_for(look);
    }
    return false;
}

/// Returns a process and those that it has started, whatever process groups they have put themselves in: a
/// starter of ranks gives each its own.
std::vector<pid_t> with_those_below(pid_t process) {
    std::vector<pid_t> all{process};
    std::error_code gone;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::filesystem::directory_iterator
                 task("/proc/" + std::to_string(all[i]) + "/task", gone),
             end;
             !gone && task != end; task.increment(gone)) {
            std::ifstream children(task->path() / "children");
            for (pid_t child = 0; children >> child;)
                all.push_back(child);
        }
    return all;
}

} // namespace

core::Result<std::vector<std::string>> program_words(std::string_view text) {
    auto words = CLI::detail::split_up(std::string(text));
    std::erase(words, "");
    if (words.empty())
        return core::fail(Error::Code::InvalidArgument, "there is no program to start ranks with",
                          "write it as \"mpirun -n 4\"");
    return words;
}

core::Result<std::unique_ptr<BricksJob>> BricksJob::start(std::vector<std::string> words) {
    int pipe[2] = {-1, -1};
    if (::pipe2(pipe, O_CLOEXEC | O_NONBLOCK) != 0)
        return core::fail(Error::Code::Io, "there are too many open files");
    OpenFile ours(pipe[0]), theirs(pipe[1]);
    const std::string program = words.front();
    ::fcntl(theirs.get(), F_SETFL, 0); // the job's writes may block
    pid_t child = -1;
    if (const int problem = spawn_job(child, std::move(words), theirs.get()); problem != 0)
        return core::fail(Error::Code::Io, "cannot start " + program + ": " +
                                               std::generic_category().message(problem));
    return std::unique_ptr<BricksJob>(new BricksJob(child, std::move(ours)));
}

BricksJob::~BricksJob() {
    if (!ends_within(process_, polls_before_term)) {
        ::kill(process_, SIGTERM); // the starter of the ranks forwards it
        (void)ends_within(process_, polls_before_kill);
    }
    for (const pid_t each : with_those_below(process_)) // the remaining processes
        ::kill(each, SIGKILL);
    ::kill(-process_, SIGKILL); // and those whose parents have ended
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::vector<std::string> BricksJob::lines() {
    std::array<char, 4096> part;
    ssize_t count = 0;
    while ((count = ::read(output_.get(), part.data(), part.size())) > 0 &&
           text_.size() < longest_word_line)
        text_.append(part.data(), static_cast<std::size_t>(count));
    ended_ = ended_ || count == 0;
    std::vector<std::string> out;
    for (auto end = text_.find('\n'); end != std::string::npos; end = text_.find('\n')) {
        out.push_back(text_.substr(0, end));
        text_.erase(0, end + 1);
    }
    if (text_.size() >= longest_word_line || (ended_ && !text_.empty()))
        out.push_back(std::exchange(text_, {}));
    return out;
}

} // namespace wakesurf::server
