// A rate with room for bursts: tokens come at a steady rate up to a most, and a caller without one waits.
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

    /// Takes `tokens`, on credit if need be. Returns how long to wait until there is no debt: zero where
    /// there is none.
    std::chrono::milliseconds take(Time now, double tokens) {
        left_ = at(now) - tokens;
        at_ = now;
        return until(0.0, left_);
    }

    /// Returns how long to wait until there are as many tokens; zero if there are.
    std::chrono::milliseconds wait_for(Time now, double tokens) const {
        return until(tokens, at(now));
    }

    /// Returns whether it is full, as at the beginning.
    bool full(Time now) const { return at(now) >= most_; }

  private:
    double at(Time now) const {
        const double elapsed = std::chrono::duration<double>(now - at_).count();
        return std::min(most_, left_ + elapsed * per_second_);
    }

    std::chrono::milliseconds until(double tokens, double left) const {
        if (left >= tokens)
            return {};
        return std::chrono::ceil<std::chrono::milliseconds>(
            std::chrono::duration<double>((tokens - left) / per_second_));
    }

    double per_second_;
    double most_;
    double left_;
    Time at_;
};

} // namespace wakesurf::server
