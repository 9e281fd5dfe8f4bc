// A rate with room for bursts: tokens come at a steady rate up to a most, and whoever has none waits.
#pragma once

#include <algorithm>
#include <chrono>

namespace wakesurf::server {

class TokenBucket {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Begins full.
    TokenBucket(double per_second, double most, Time now)
        : per_second_(per_second), most_(most), left_(most), at_(now) {}

    /// Takes `tokens`, on credit if need be. Gives how long to wait until there is no debt: zero where there is none.
    std::chrono::milliseconds take(Time now, double tokens) {
        const double elapsed = std::chrono::duration<double>(now - at_).count();
        left_ = std::min(most_, left_ + elapsed * per_second_) - tokens;
        at_ = now;
        if (left_ >= 0.0)
            return {};
        return std::chrono::ceil<std::chrono::milliseconds>(
            std::chrono::duration<double>(-left_ / per_second_));
    }

  private:
    double per_second_;
    double most_;
    double left_;
    Time at_;
};

} // namespace wakesurf::server
