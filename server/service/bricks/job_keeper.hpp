// The job from its start to its end, and then the next one after a rest, which is longer each time until one is there again.
#pragma once

#include "core/base/result.hpp"
#include "server/service/bricks/bricks_job.hpp"
#include "server/service/bricks/job_talk.hpp"
#include "server/service/bricks/local_socket.hpp"
#include "server/service/bricks/rank_options.hpp"

#include <poll.h>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace wakesurf::server {

/// One thread at a time. Never waits, but for a job that is ended.
class JobKeeper {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param options, wanted  live longer
    JobKeeper(const RankOptions& options, const WantedJob& wanted)
        : options_(options), wanted_(wanted), rest_(options.first_rest) {}

    /// Starts a job when the rest is over, writes into the log what it says, lets it in. True where it is there from now on. Error: why
    /// it has to be ended.
    core::Result<bool> tend();

    /// With the job that is there; null while none is.
    JobTalk* talk() { return talk_ ? &*talk_ : nullptr; }

    /// Ends what there is, and the next one is started after a rest.
    void end();

    /// What becomes readable when there is something to tend.
    void watch(std::vector<pollfd>& files) const;

    /// When there is something to tend although nothing becomes readable. Time::max(): never.
    Time due() const;

  private:
    core::Result<void> start();
    core::Result<bool> let_in();
    void listen();

    const RankOptions& options_;
    const WantedJob& wanted_;
    std::optional<LocalDoor>
        door_; // what comes first ends last: a job ends by itself when it hears that the talk is over
    std::unique_ptr<BricksJob> job_;
    std::optional<OpenFile> guest_; ///< knocked, and has not said who it is
    std::optional<JobTalk> talk_;
    Time started_{}, next_start_{};
    RankOptions::Duration rest_;
};

} // namespace wakesurf::server
