// Whose job is next: the session that has been served least. Start-time fair queueing (Goyal, Vin and Cheng,
// 1996): a session that starts to compete begins level with the others, so idle time earns no credit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Not thread safe. Cost of every call: O(sessions that have jobs or were served lately).
class FairQueue {
  public:
    using Job = std::function<void()>;

    /// @param at_once  jobs of one session that run at a time
    explicit FairQueue(std::size_t at_once) : at_once_(at_once) {}

    void push(const std::string& session, Job job);

    struct Turn {
        std::string session;
        Job job;
    };

    /// Returns the oldest job of the session that has been served least, of equal ones the one that waits for
    /// its turn longest. Empty if no job may run now.
    std::optional<Turn> pop();

    /// Reports that a job that pop() returned has run, and charges its session. REQUIRES: every job is
    /// reported.
    void done(const std::string& session, double seconds);

    /// Returns the number of jobs that pop() has not returned yet.
    std::size_t waiting() const { return waiting_; }

  private:
    struct Line {
        std::deque<Job> jobs;
        std::size_t running = 0;
        double served = 0.0;    ///< s of virtual time
        std::uint64_t turn = 0; ///< when it last had one, or began to wait for it
    };

    bool ready(const Line& line) const;
    void compete(Line& line);
    void forget_idle();

    std::size_t at_once_;
    std::size_t waiting_ = 0;
    double now_ = 0.0; ///< virtual time: what the session that had the last turn had been served
    std::uint64_t turns_ = 0;
    std::map<std::string, Line> lines_; ///< of sessions with jobs, or served beyond `now_`
};

} // namespace wakesurf::server
