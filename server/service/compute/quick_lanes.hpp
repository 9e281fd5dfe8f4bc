// Quick passes on threads of two priorities, so that a person who edits a little is answered at once beside sessions that keep every
// processor busy. The upper threads are for sessions that have used little lately, and never all of them for one; the rest runs on
// the lower threads, which take what the upper ones and the network leave.
#pragma once

#include "server/service/compute/fair_queue.hpp"
#include "server/service/compute/recent_use.hpp"

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

    /// What a session may use and still have the upper threads, in processors, over about `memory`; shared by the busy ones
    /// where they are more than two, as then all of them together would keep the upper threads from others.
    static constexpr double fair_share = 0.5;
    static constexpr double busy = 0.05;
    static constexpr std::chrono::milliseconds memory{250};

    /// @param upper  threads of that lane, at least 2
    explicit QuickLanes(std::size_t upper) : most_(upper - 1) {}

    /// Returns the lane whose thread will get it.
    Lane push(const std::string& session, FairQueue::Job job, Time now);

    /// Nothing when none waits in that lane. On the upper threads the session goes first that has used least, on the lower ones sessions
    /// take turns.
    std::optional<FairQueue::Turn> pop(Lane lane, Time now);

    /// Of the upper lane, for the thread that only takes sessions that use less than half of what they may: it is never kept by those
    /// that are about to be lowered.
    std::optional<FairQueue::Turn> pop_light(Time now);

    /// What pop() or pop_light() returned has run and took so many seconds of a processor.
    void done(Lane lane, const std::string& session, double seconds, Time now);

    bool ready(Lane lane) const { return queues_[static_cast<std::size_t>(lane)].ready(); }

    /// Jobs that pop() has not given yet.
    std::size_t waiting(Lane lane) const {
        return queues_[static_cast<std::size_t>(lane)].waiting();
    }

  private:
    double most_share(Time now) const;
    FairQueue::Used used(Time now) const;

    FairQueue& of(Lane lane) { return queues_[static_cast<std::size_t>(lane)]; }

    std::size_t most_;
    std::array<FairQueue, 2> queues_{FairQueue{false}, FairQueue{false}};
    RecentUse use_{memory};                    ///< of processors
    std::map<std::string, std::size_t> upper_; ///< jobs waiting or running there
};

} // namespace wakesurf::server
