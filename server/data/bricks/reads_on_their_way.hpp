// The pending requests of a job: which read waits for which slot, and for how long.
#pragma once

#include "server/data/bricks/rank_options.hpp"
#include "server/data/bricks/waiting_read.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::server {

/// Holds the requests of one job. One thread at a time.
class ReadsOnTheirWay {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param options  patience, hung and clock; outlives this
    explicit ReadsOnTheirWay(const RankOptions& options) : options_(options) {}

    /// Adds requests. REQUIRES: as many slots as reads, none of them pending.
    void add(std::span<const std::uint32_t> slots, std::vector<WaitingRead> reads);

    /// Removes the request of a filled slot and returns its read; empty if it was late.
    std::optional<WaitingRead> take(std::uint32_t slot);

    /// Returns the reads that have waited too long, to be made from files. Their slots stay in use until the
    /// job answers.
    std::vector<WaitingRead> late();

    /// Says whether no read waits for the job: there is none, or all are late.
    bool nobody_waits() const;

    /// Says whether an answer is long overdue, despite other answers: a rank may hang.
    bool hung() const;

    /// Returns the next time at which late() or hung() may change if the job does not answer. Time::max():
    /// never.
    Time due() const;

    /// Returns the reads that still wait, and removes all requests.
    std::vector<WaitingRead> end();

  private:
    struct OnItsWay {
        /// The read; empty once files make it.
        std::optional<WaitingRead> read;
        Time since;
    };

    const RankOptions& options_;
    std::map<std::uint32_t, OnItsWay> by_slot_;
};

} // namespace wakesurf::server
