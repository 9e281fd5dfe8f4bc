// How many calls one client may make: a bucket of tokens that fills with time, one for calls that edit and one for all.
#pragma once

#include <chrono>
#include <optional>

namespace wakesurf::server {

/// REQUIRES: `now` does not go back from call to call.
class CallRate {
  public:
    using Time = std::chrono::steady_clock::time_point;

    CallRate();

    /// Takes a token for one call. Nothing: go on; otherwise how long until there is one.
    std::optional<std::chrono::milliseconds> take(bool edits, Time now);

  private:
    struct Bucket {
        double per_second;
        double most;
        double left;

        void fill(double seconds);
        std::chrono::milliseconds wait() const;
    };

    Bucket calls_;
    Bucket edits_;
    std::optional<Time> filled_;
};

} // namespace wakesurf::server
