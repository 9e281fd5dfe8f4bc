// What a job has been asked for: which read waits for which slot, and how long it waits.
#pragma once

#include "server/service/bricks/rank_options.hpp"
#include "server/service/bricks/waiting_read.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::server {

/// Of one job. One thread at a time.
class ReadsOnTheirWay {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param options  lives longer: patience, hung, clock
    explicit ReadsOnTheirWay(const RankOptions& options) : options_(options) {}

    /// The job has been asked for these. REQUIRES: as many slots as reads, none of them on its way.
    void add(std::span<const std::uint32_t> slots, std::vector<WaitingRead> reads);

    /// The job has filled a slot: the read that waits for it. Nothing where it was late.
    std::optional<WaitingRead> take(std::uint32_t slot);

    /// Whose patience is over, so that files read them. Their slots are taken until the job answers.
    std::vector<WaitingRead> late();

    /// No read waits for the job: none was asked for, or all are late.
    bool nobody_waits() const;

    /// The job owes an answer for too long, whatever else it answers: one of its ranks may hang.
    bool hung() const;

    /// When one of both becomes so, if the job says nothing. Time::max(): never.
    Time due() const;

    /// Who still waits. Nothing is on its way then.
    std::vector<WaitingRead> end();

  private:
    struct OnItsWay {
        std::optional<WaitingRead> read; ///< none: files have it by now
        Time since;
    };

    const RankOptions& options_;
    std::map<std::uint32_t, OnItsWay> by_slot_;
};

} // namespace wakesurf::server
