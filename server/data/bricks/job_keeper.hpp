// Starts the job, follows it to its end, and starts the next one after a pause, which doubles until one
// connects again.
#pragma once

#include "core/base/result.hpp"
#include "server/data/bricks/bricks_job.hpp"
#include "server/data/bricks/job_talk.hpp"
#include "server/data/bricks/local_socket.hpp"
#include "server/data/bricks/rank_options.hpp"

#include <poll.h>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace wakesurf::server {

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
