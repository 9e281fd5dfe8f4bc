// Long jobs on threads of two kinds, so that a small surface is whole soon beside sessions that keep every thread busy: some threads are
// for sessions that have taken little of them lately, all others for any session in its turn. A new session counts as light until its
// first job has run, so jobs that turn out to be long do not keep the next one waiting.
#pragma once

#include "server/service/compute/fair_queue.hpp"
#include "server/service/compute/recent_use.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Not thread safe. Cost of every call: O(sessions that have jobs waiting).
class LongLanes {
  public:
    enum class Lane { Light, Any };

    using Time = RecentUse::Time;

    /// Of one thread's time over about `memory`, waiting for memory or time-steps included: what is more is not light.
    static constexpr double light_share = 0.5;
    static constexpr std::chrono::milliseconds memory{4000};

    /// So many light jobs run that began within the last `settling`; older ones no longer count.
    static constexpr std::size_t light_jobs = 2;
    static constexpr std::chrono::milliseconds settling{500};

    void push(const std::string& session, FairQueue::Job job) {
        queue_.push(session, std::move(job));
    }

    /// A job that belongs to no session, and is never light.
    void push_lone(FairQueue::Job job);

    /// Nothing when none waits for that lane. Of a session one job runs at a time.
    std::optional<FairQueue::Turn> pop(Lane lane, Time now);

    bool ready(Lane lane, Time now) const;

    /// What pop() returned has run and took so many seconds of its thread.
    void done(const std::string& session, double seconds, Time now);

    /// Jobs that pop() has not returned yet.
    std::size_t waiting() const { return queue_.waiting(); }

  private:
    FairQueue::Used used(Time now) const;
    bool room(Time now) const; ///< for another light job

    FairQueue queue_{true};
    RecentUse use_{memory};
    std::set<std::string> lone_; ///< stand for sessions
    std::uint64_t next_lone_ = 0;
    std::map<std::string, Time> running_; ///< light jobs, and when they began
};

} // namespace wakesurf::server
