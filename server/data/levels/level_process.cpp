#include "server/data/levels/level_process.hpp"

#include "core/base/blocking_wait.hpp"
#include "server/base/shipped_files.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

extern char** environ;

namespace wakesurf::server {

using core::Error;
using ProcessTime = std::chrono::steady_clock;

namespace {

constexpr std::chrono::milliseconds answer_poll_interval{20};
constexpr std::size_t most_words = 4096;

/// Returns the bound on points of a complete answer: a point is shared by at least two triangles, or lies at
/// a border.
constexpr std::uint64_t most_points_of(std::uint64_t triangles) {
    return 3 * triangles;
}

/// Holds one descriptor for both directions, and one for standard error.
struct LevelEnds {
    int ours = -1, theirs = -1, errors = -1, their_errors = -1;

    LevelEnds() {
        int pair[2], pipe[2];
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) == 0) {
            ours = pair[0];
            theirs = pair[1];
        }
        if (::pipe2(pipe, O_CLOEXEC | O_NONBLOCK) == 0) {
            errors = pipe[0];
            their_errors = pipe[1];
        }
    }

    ~LevelEnds() {
        for (const int file : {ours, theirs, errors, their_errors})
            if (file >= 0)
                ::close(file);
    }

    LevelEnds(const LevelEnds&) = delete;
    LevelEnds& operator=(const LevelEnds&) = delete;

    bool there() const { return ours >= 0 && errors >= 0; }
};

int spawn_extractor(pid_t& child,
                    const std::string& program,
                    std::vector<std::string> words,
                    const LevelEnds& ends,
                    int memory) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends.theirs, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, ends.theirs, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, ends.their_errors, STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, memory, importer::level_memory);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, importer::level_memory + 1);
    sigset_t none, ending;
    ::sigemptyset(&none);
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
        ::sigaddset(&ending, signal);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &ending);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int problem =
        ::posix_spawn(&child, program.c_str(), &actions, &attributes, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    return problem;
}

std::string extractor_words(int errors) {
    std::string words(most_words, '\0');
    const auto count = ::read(errors, words.data(), words.size());
    words.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    if (const auto end = words.find('\n'); end != std::string::npos)
        words.resize(end);
    constexpr std::string_view prefix = "wakesurf-import: ";
    return words.starts_with(prefix) ? words.substr(prefix.size()) : words;
}

} // namespace

core::Result<std::unique_ptr<LevelProcess>> LevelProcess::start(const LevelMemory& memory,
                                                                const Options& options) {
    const auto program = options.program.empty() ? this_program().parent_path() / "wakesurf-import"
                                                 : options.program;
    std::vector<std::string> words{program.string(), "--level-sets",
                                   "--parent=" + std::to_string(::getpid())};
    if (options.memory > 0)
        words.push_back("--memory=" + std::to_string(options.memory));
    LevelEnds ends;
    pid_t child = -1;
    const int problem = ends.there() ? spawn_extractor(child, program.string(), std::move(words),
                                                       ends, memory.file())
                                     : EMFILE;
    if (problem != 0)
        return core::fail(Error::Code::Io, "cannot start " + program.filename().string() + ": " +
                                               std::generic_category().message(problem));
    return std::unique_ptr<LevelProcess>(new LevelProcess(child, std::exchange(ends.ours, -1),
                                                          std::exchange(ends.errors, -1), options));
}

/// Processes started by it end with it.
LevelProcess::~LevelProcess() {
    ::kill(process_, SIGKILL);
    ::close(talk_);
    ::close(errors_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

Error LevelProcess::give_up(const std::string& why) {
    usable_ = false;
    return {Error::Code::Io, "the level set was not extracted: " + why,
            "set the surface again: a new process will try it"};
}

Error LevelProcess::ended() {
    const std::string words = extractor_words(errors_);
    if (words.find("too much memory") != std::string::npos) {
        usable_ = false;
        return {Error::Code::OverLimit, "there is not enough memory for this level set",
                "start with a larger --memory, or choose another level"};
    }
    gone_ = true;
    return give_up("the process that extracts it ended" + (words.empty() ? "" : ": " + words));
}

core::Result<void> LevelProcess::send(const importer::LevelRequest& request) {
    const auto sent = ::send(talk_, &request, sizeof(request), MSG_NOSIGNAL);
    return sent == static_cast<ssize_t>(sizeof(request)) ? core::Result<void>{}
                                                         : tl::unexpected(ended());
}

/// Returns the processor time of what extracts: the child of the process that watches it, whose own time
/// passes always.
std::chrono::nanoseconds LevelProcess::worked() const {
    const std::string id = std::to_string(process_);
    std::ifstream children("/proc/" + id + "/task/" + id + "/children");
    std::chrono::nanoseconds sum{0};
    for (pid_t child = 0; children >> child;) {
        clockid_t clock{};
        timespec time{};
        if (::clock_getcpuclockid(child, &clock) == 0 && ::clock_gettime(clock, &time) == 0)
            sum += std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    }
    return sum;
}

/// Received bytes stay in `part_`, also after an error. @param bytes  that `part_` is to have
core::Result<void> LevelProcess::read(std::size_t bytes, const std::stop_token& stop) {
    const core::BlockingWait blocked;
    const auto begun = ProcessTime::now();
    auto seen = begun;
    auto before = worked();
    while (part_.size() < bytes) {
        pollfd file{talk_, POLLIN, 0};
        const int ready = ::poll(&file, 1, static_cast<int>(answer_poll_interval.count()));
        const auto now = ProcessTime::now();
        if (ready > 0) {
            const std::size_t there = part_.size();
            part_.resize(bytes);
            const auto count = ::read(talk_, part_.data() + there, bytes - there);
            part_.resize(there + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
            if (count == 0 || (count < 0 && errno != EINTR))
                return tl::unexpected(ended());
            seen = now;
        } else if (stop.stop_requested()) {
            return core::fail(Error::Code::Cancelled, "the level set was cancelled");
        } else if (now - seen >= options_.patience) {
            const auto after = worked();
            if (std::exchange(before, after) == after || now - begun >= options_.longest)
                return tl::unexpected(give_up("the process that extracts it does not answer"));
            seen = now;
        }
    }
    return {};
}

core::Result<LevelMesh> LevelProcess::answer(const std::stop_token& stop) {
    if (auto came = read(sizeof(importer::LevelAnswer), stop); !came)
        return tl::unexpected(came.error());
    importer::LevelAnswer head;
    std::memcpy(&head, part_.data(), sizeof(head));
    if (head.magic != importer::level_magic || head.number != number_)
        return tl::unexpected(give_up("the process that extracts it answered what is none"));
    if (head.triangles > most_) {
        asked_ = false;
        part_.clear();
        return core::over_limit(most_, std::to_string(head.triangles) + " triangles");
    }
    if (head.points > most_points_of(head.triangles))
        return tl::unexpected(give_up("the process that extracts it answered what cannot be"));
    const std::size_t points = head.points * sizeof(core::Vec3);
    const std::size_t triangles = head.triangles * 3 * sizeof(std::uint32_t);
    if (auto came = read(sizeof(head) + points + triangles, stop); !came)
        return tl::unexpected(came.error());
    LevelMesh mesh;
    mesh.points.resize(head.points);
    mesh.triangles.resize(head.triangles);
    const std::byte* at = part_.data() + sizeof(head);
    if (points > 0)
        std::memcpy(mesh.points.data(), at, points);
    if (triangles > 0)
        std::memcpy(mesh.triangles.data(), at + points, triangles);
    part_.clear();
    asked_ = false;
    const auto there = [&](const auto& triangle) {
        return std::ranges::all_of(triangle,
                                   [&](std::uint32_t each) { return each < head.points; });
    };
    if (!std::ranges::all_of(mesh.triangles, there))
        return tl::unexpected(give_up("the process that extracts it answered what cannot be"));
    return mesh;
}

core::Result<void> LevelProcess::rest(const std::stop_token& stop) {
    if (!asked_)
        return {};
    auto late = answer(stop);
    if (late || late.error().code == Error::Code::OverLimit)
        return {};
    return tl::unexpected(late.error());
}

core::Result<LevelMesh> LevelProcess::extract(importer::LevelRequest request,
                                              const std::stop_token& stop) {
    if (auto rested = rest(stop); !rested)
        return tl::unexpected(rested.error());
    request.number = ++number_;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    asked_ = true;
    most_ = request.most_triangles;
    return answer(stop);
}

} // namespace wakesurf::server
