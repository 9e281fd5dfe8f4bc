// Ctrl-C and SIGTERM as a stop_token, for commands that run to an end (import, info, surface).
#pragma once

#include <signal.h>

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

} // namespace wakesurf::server
