// A clock that continues while the machine sleeps, as a laptop does, and that cannot be set.
#pragma once

#include "core/base/clock.hpp"

#include <time.h>

namespace wakesurf::server {

class WakingClock final : public core::Clock {
  public:
    std::chrono::steady_clock::time_point now() const override {
        timespec now{};
        ::clock_gettime(CLOCK_BOOTTIME, &now);
        return std::chrono::steady_clock::time_point(std::chrono::seconds(now.tv_sec) +
                                                     std::chrono::nanoseconds(now.tv_nsec));
    }
};

} // namespace wakesurf::server
