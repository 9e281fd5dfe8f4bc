// Quick passes on threads of two priorities, so that whoever edits a little is answered at once beside sessions that keep every
// processor busy. The upper threads are for sessions that have used little lately, and never all of them for one; the rest runs on
// the lower threads, which take what the upper ones and the network leave.
#pragma once

#include "server/session/fair_queue.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Not thread safe. Cost of every call: O(log sessions).
class QuickLanes {
  public:
    enum class Lane { Upper, Lower };

    using Time = std::chrono::steady_clock::time_point;

    /// What a session may use of the upper threads, in processors, over about `memory`.
    static constexpr double fair_share = 0.5;
    static constexpr std::chrono::milliseconds memory{250};

    /// @param upper  threads of that lane, at least 2
    explicit QuickLanes(std::size_t upper) : most_(upper - 1) {}

    /// Returns the lane whose thread will get it.
    Lane push(const std::string& session, FairQueue::Job job, Time now);

    /// Nothing when none waits in that lane. In each lane sessions take turns.
    std::optional<FairQueue::Turn> pop(Lane lane) { return of(lane).pop(); }

    /// What pop() gave has run and took so many seconds of a processor.
    void done(Lane lane, const std::string& session, double seconds, Time now);

    bool ready(Lane lane) const { return queues_[static_cast<std::size_t>(lane)].ready(); }

    /// Jobs that pop() has not given yet.
    std::size_t waiting(Lane lane) const {
        return queues_[static_cast<std::size_t>(lane)].waiting();
    }

  private:
    /// Processor time, forgotten by and by.
    struct Use {
        double seconds = 0.0;
        Time since{};
        std::size_t upper = 0; ///< jobs waiting or running there

        double at(Time now) const;
    };

    FairQueue& of(Lane lane) { return queues_[static_cast<std::size_t>(lane)]; }

    void forget_idle(Time now);

    std::size_t most_;
    std::array<FairQueue, 2> queues_{FairQueue{false}, FairQueue{false}};
    std::map<std::string, Use> uses_;
    Time swept_{};
};

} // namespace wakesurf::server
