#include "server/data/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

extern char** environ;

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;
constexpr std::size_t longest_errors = std::size_t{16} << 10;
constexpr int ending_patience =
    2000; // milliseconds in which a child that was asked to end says nothing

class Pipe {
  public:
    Pipe() {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
            ends_ = {-1, -1};
    }

    ~Pipe() {
        close(0);
        close(1);
    }

    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reading() const { return ends_[0]; }

    int writing() const { return ends_[1]; }

    void close(std::size_t end) {
        if (const int file = std::exchange(ends_[end], -1); file >= 0)
            ::close(file);
    }

  private:
    std::array<int, 2> ends_{-1, -1};
};

class SpawnOptions {
  public:
    SpawnOptions(const Pipe& out, const Pipe& errors) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions_, out.writing(), STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions_, errors.writing(), STDERR_FILENO);
        // Sockets are inherited by another program. A child that outlives a killed server would keep its port
        // in use and its clients waiting.
        ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
        // The child must be endable, whatever this process ignores or blocks.
        sigset_t none;
        sigset_t ending;
        ::sigemptyset(&none);
        ::sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
            ::sigaddset(&ending, signal);
        ::posix_spawnattr_init(&attributes_);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setsigdefault(&attributes_, &ending);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }

    ~SpawnOptions() {
        ::posix_spawn_file_actions_destroy(&actions_);
        ::posix_spawnattr_destroy(&attributes_);
    }

    SpawnOptions(const SpawnOptions&) = delete;
    SpawnOptions& operator=(const SpawnOptions&) = delete;

    int spawn(pid_t& child, const std::filesystem::path& program, std::vector<char*>& words) {
        return ::posix_spawn(&child, program.c_str(), &actions_, &attributes_, words.data(),
                             environ);
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

// Reads available bytes; returns false at the end.
bool read_some(int file, std::string& into) {
    std::array<char, 4096> buffer;
    const auto count = ::read(file, buffer.data(), buffer.size());
    if (count > 0)
        into.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

void take_lines(std::string& text, const std::function<void(std::string_view)>& line) {
    std::size_t start = 0;
    for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n', start)) {
        line(std::string_view(text).substr(start, end - start));
        start = end + 1;
    }
    text.erase(0, start);
    if (text.size() > longest_line)
        text.clear();
}

/// Reads what the child says until it ends, or until it has been killed because it did not end when asked to.
/// @param asked  readable once it has been asked to
std::string listen(const Pipe& out,
                   const Pipe& errors,
                   const Pipe& asked,
                   pid_t child,
                   const std::function<void(std::string_view)>& line) {
    std::string text;
    std::string last_words;
    std::array<pollfd, 3> files{
        {{out.reading(), POLLIN, 0}, {errors.reading(), POLLIN, 0}, {asked.reading(), POLLIN, 0}}};
    while (files[0].fd >= 0 || files[1].fd >= 0) {
        const bool ending = files[2].fd < 0;
        const int ready = ::poll(files.data(), files.size(), ending ? ending_patience : -1);
        if (ready < 0 && errno != EINTR)
            break;
        if (ready == 0) { // a stopped one heeds nothing else
            ::kill(child, SIGKILL);
            break;
        }
        if (files[2].revents != 0)
            files[2].fd = -1;
        if (files[0].revents != 0 && !read_some(files[0].fd, text))
            files[0].fd = -1;
        if (files[1].revents != 0 && !read_some(files[1].fd, last_words))
            files[1].fd = -1;
        take_lines(text, line);
        if (last_words.size() > longest_errors)
            last_words.erase(0, last_words.size() - longest_errors);
    }
    if (!text.empty())
        line(text);
    return last_words;
}

void limit(pid_t child, std::size_t address_space) {
    const rlimit no_core{0, 0};
    ::prlimit(child, RLIMIT_CORE, &no_core, nullptr);
    const rlimit space{address_space, address_space};
    if (address_space > 0)
        ::prlimit(child, RLIMIT_AS, &space, nullptr);
}

} // namespace

core::Result<ChildOutcome> run_child(const std::filesystem::path& program,
                                     const std::vector<std::string>& arguments,
                                     std::size_t address_space,
                                     const std::function<void(std::string_view)>& line,
                                     std::stop_token stop) {
    Pipe out;
    Pipe errors;
    Pipe asked;
    std::vector<std::string> texts{program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    std::transform(texts.begin(), texts.end(), std::back_inserter(words),
                   [](std::string& text) { return text.data(); });
    words.push_back(nullptr);
    pid_t child = -1;
    const int problem = out.reading() < 0 || errors.reading() < 0 || asked.reading() < 0
                            ? EMFILE
                            : SpawnOptions(out, errors).spawn(child, program, words);
    if (problem != 0)
        return core::fail(Error::Code::Io, "cannot start " + program.filename().string() + ": " +
                                               std::generic_category().message(problem));
    limit(child, address_space);
    out.close(1);
    errors.close(1);
    ChildOutcome outcome;
    siginfo_t ended{};
    {
        // The child is not reaped in here, so its id cannot be another process's.
        const std::stop_callback end(stop, [child, &asked] {
            ::kill(child, SIGTERM);
            asked.close(1);
        });
        outcome.errors = listen(out, errors, asked, child, line);
        while (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) != 0 &&
               errno == EINTR) {
        }
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    outcome.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return outcome;
}

} // namespace wakesurf::server
