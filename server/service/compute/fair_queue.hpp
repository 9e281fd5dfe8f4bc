// Whose job is next: sessions take turns, whatever each of them has waiting; within a session the oldest goes first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Not thread safe. Cost of every call: O(log sessions).
class FairQueue {
  public:
    using Job = std::function<void()>;

    /// @param one_a_session  the next job of a session has its turn only after done() of the one before
    explicit FairQueue(bool one_a_session) : one_a_session_(one_a_session) {}

    void push(const std::string& session, Job job);

    struct Turn {
        std::string session;
        Job job;
    };

    /// Nothing when no job may run now.
    std::optional<Turn> pop();

    /// Out of turn: of the session that has used least, the first in turn of several; of none that has used `most` or more.
    using Used = std::function<double(const std::string& session)>;
    std::optional<Turn> pop_least(const Used& used, double most);

    /// The job that pop() gave has run. Every job must be reported, in either mode.
    void done(const std::string& session);

    /// Jobs that pop() has not given yet.
    std::size_t waiting() const { return waiting_; }

    /// Whether pop() would return one.
    bool ready() const { return !turns_.empty(); }

    bool ready_below(const Used& used, double most) const {
        return std::any_of(turns_.begin(), turns_.end(),
                           [&](const std::string& session) { return used(session) < most; });
    }

  private:
    std::optional<Turn> take(std::deque<std::string>::iterator session);

    struct Line {
        std::deque<Job> jobs;
        std::size_t running = 0;
    };

    bool one_a_session_;
    std::size_t waiting_ = 0;
    std::map<std::string, Line> lines_; ///< of sessions with jobs waiting or running
    std::deque<std::string> turns_;     ///< sessions that may run a job, each once
};

} // namespace wakesurf::server
