// Whose job is next: sessions take turns, however many jobs each of them has waiting; within a session the
// oldest goes first. A session that has used little lately is light, and its jobs may be taken first.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Counts how much each session has used of a processor or of a thread lately, in seconds that decay
/// exponentially.
/// Not thread safe. Cost of every call: O(log sessions).
class RecentUse {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param memory  what was used so long ago counts for 1/e
    explicit RecentUse(std::chrono::milliseconds memory) : memory_(memory) {}

    void add(const std::string& session, double seconds, Time now);

    /// Returns the share of that time: 1 for a session that has used one thread all the time.
    double share(const std::string& session, Time now) const;

    /// Sessions whose share is more. Cost: O(sessions that have used anything lately).
    std::size_t busier_than(double share, Time now) const;

  private:
    struct Use {
        double seconds = 0.0;
        Time since{};
    };

    double at(const Use& use, Time now) const;
    void forget_idle(Time now);

    std::chrono::milliseconds memory_;
    std::map<std::string, Use> uses_;
    Time swept_{};
};

/// Not thread safe. Cost of every call: O(sessions with jobs, log sessions).
class FairQueue {
  public:
    using Job = std::function<void()>;
    using Time = RecentUse::Time;

    struct Rules {
        /// Jobs of one session that run at a time. It is not light while `light_at_once` of them run.
        std::size_t at_once;
        std::size_t light_at_once;

        /// A session is light below this share of a thread or processor over about `memory`. Sessions with
        /// a share above `busy` divide it where they are more than two: all of them together would
        /// otherwise fill the threads for light ones.
        double light_share;
        double busy;
        std::chrono::milliseconds memory;
    };

    explicit FairQueue(const Rules& rules) : rules_(rules), use_(rules.memory) {}

    void push(const std::string& session, Job job);

    struct Turn {
        std::string session;
        Job job;
    };

    enum class Takes { Any, Light, NotLight };

    /// Returns the next job of the sessions that `which` names: in turn, but of the light ones the session
    /// that has used least goes first. Empty if no such job may run now.
    std::optional<Turn> pop(Takes which, Time now);

    /// Reports that a job that pop() returned has run and used `seconds`. REQUIRES: every job is reported.
    void done(const std::string& session, double seconds, Time now);

    /// Returns the number of jobs that pop() has not returned yet.
    std::size_t waiting() const { return waiting_; }

  private:
    struct Line {
        std::deque<Job> jobs;
        std::size_t running = 0;
    };

    Turn take(std::deque<std::string>::iterator session);
    bool ready(const Line& line) const;

    Rules rules_;
    RecentUse use_;
    std::size_t waiting_ = 0;
    std::map<std::string, Line> lines_; ///< of sessions with jobs waiting or running
    std::deque<std::string> turns_;     ///< sessions that may run a job, each once
};

} // namespace wakesurf::server
