// The MPI job that holds a store's bricks, as a child of the server: started, read, ended. POSIX, no shell.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"
#include "server/data/bricks/job_talk.hpp"
#include "server/data/bricks/local_socket.hpp"
#include "server/data/bricks/rank_options.hpp"

#include <poll.h>
#include <sys/types.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Splits a command line into words at blanks; quotes keep words together. No variables, no patterns. Error:
/// InvalidArgument without a word.
core::Result<std::vector<std::string>> program_words(std::string_view text);

/// A child and all processes that it starts on this machine. The destructor asks it to end, and kills it
/// after some seconds.
class BricksJob {
  public:
    /// Starts a job; its first word is looked up in PATH. Error: Io if it cannot be started.
    static core::Result<std::unique_ptr<BricksJob>> start(std::vector<std::string> words);
    ~BricksJob();
    BricksJob(const BricksJob&) = delete;
    BricksJob& operator=(const BricksJob&) = delete;

    /// Returns a descriptor that becomes readable with output or at the end.
    int output() const { return output_.get(); }

    /// Returns the whole lines of output since the last call.
    std::vector<std::string> lines();

    /// Says whether its output has ended.
    bool ended() const { return ended_; }

  private:
    BricksJob(pid_t process, OpenFile output) : process_(process), output_(std::move(output)) {}

    pid_t process_;
    OpenFile output_;
    std::string text_;
    bool ended_ = false;
};

/// Starts the job, follows it to its end, and starts the next one after a pause, which doubles until one
/// connects again.
/// Keeps a job running. One thread at a time. Never blocks, except to end a job.
class JobKeeper {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// REQUIRES: both arguments outlive this.
    JobKeeper(const RankOptions& options, const WantedJob& wanted)
        : options_(options), wanted_(wanted), rest_(options.first_rest) {}

    /// Starts a job when the pause is over, logs its output, connects it. Returns true if it is connected
    /// from now on. Error: why it has to be ended.
    core::Result<bool> tend();

    /// Returns the connected job; null without one.
    JobTalk* talk() { return talk_ ? &*talk_ : nullptr; }

    /// Ends the job; the next one is started after a pause.
    void end();

    /// Adds the descriptors that become readable when tend() has work.
    void watch(std::vector<pollfd>& files) const;

    /// Returns the time at which tend() has work in any case. Time::max(): never.
    Time due() const;

  private:
    core::Result<void> start();
    core::Result<bool> let_in();
    void listen();

    const RankOptions& options_;
    const WantedJob& wanted_;
    std::optional<LocalDoor>
        door_; // declared first, destroyed last: a job ends by itself when its connection closes
    std::unique_ptr<BricksJob> job_;
    /// Has connected, but not identified itself yet.
    std::optional<OpenFile> guest_;
    std::optional<JobTalk> talk_;
    Time started_{}, next_start_{};
    RankOptions::Duration rest_;
};

} // namespace wakesurf::server
