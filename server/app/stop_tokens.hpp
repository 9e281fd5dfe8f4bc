// Stop tokens of commands that run to an end (import, info, surface): of Ctrl-C and SIGTERM, and of a limit of the wall clock.
#pragma once

#include <signal.h>

#include <atomic>
#include <functional>
#include <stop_token>
#include <thread>

namespace wakesurf::server {

/// Turns the two signals into a stop request while it lives. Threads started after it inherit that; start it
/// before any other thread.
class StopOnSignal {
  public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    std::stop_token token() const { return source_.get_token(); }

  private:
    std::stop_source source_;
    sigset_t before_{};
    std::jthread waiter_;
};

/// A limit of the wall clock for a command: its token fires when the time is over, or when another one does.
class TimeLimit {
  public:
    /// @param seconds  from now on; 0: no limit
    /// @param also     fires the token as well, without making over() true
    TimeLimit(double seconds, std::stop_token also);
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    std::stop_token token() const { return source_.get_token(); }

    bool set() const { return seconds_ > 0.0; }

    double seconds() const { return seconds_; }

    /// Says whether the time is over.
    bool over() const { return over_; }

  private:
    double seconds_;
    std::atomic<bool> over_{false};
    std::stop_source source_;
    std::stop_callback<std::function<void()>> forward_;
    std::jthread waiter_; ///< destroyed first: it uses the others
};

} // namespace wakesurf::server
