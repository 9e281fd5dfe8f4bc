// Time as an injected value, so that whole sessions can be simulated and replayed.
#pragma once

#include <chrono>

namespace wakesurf::core {

/// Thread safety: implementations must allow concurrent calls of now().
class Clock {
  public:
    virtual ~Clock() = default;
    /// Returns a time that never decreases.
    virtual std::chrono::steady_clock::time_point now() const = 0;
};

/// Reads the machine's monotonic clock.
class SteadyClock final : public Clock {
  public:
    /// Returns the time of std::chrono::steady_clock.
    std::chrono::steady_clock::time_point now() const override {
        return std::chrono::steady_clock::now();
    }
};

} // namespace wakesurf::core
