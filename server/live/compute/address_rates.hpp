// A rate for each address that asks, of what needs no token. Beyond limits::addresses of them the further
// ones share one.
#pragma once

#include "core/base/clock.hpp"
#include "server/live/compute/token_bucket.hpp"

#include <chrono>
#include <map>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class AddressRates {
  public:
    /// REQUIRES: the clock outlives it.
    AddressRates(double per_second, double at_once, const core::Clock& clock)
        : per_second_(per_second), at_once_(at_once), clock_(clock) {}

    /// Returns how long to wait until one more may come; zero if it may come now.
    std::chrono::milliseconds wait_for(const std::string& from);

    /// On credit, if need be.
    void take(const std::string& from, double count);

  private:
    TokenBucket& of(const std::string& from);

    double per_second_;
    double at_once_;
    const core::Clock& clock_;
    std::map<std::string, TokenBucket> left_;
};

} // namespace wakesurf::server
