// A limit of the wall clock for a command: a stop_token that fires when the time is over, or when another one
// does.
#pragma once

#include <atomic>
#include <functional>
#include <stop_token>
#include <thread>

namespace wakesurf::server {

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
