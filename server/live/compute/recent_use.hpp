// Counts how much each session has used of a processor or of a thread lately, in seconds that decay
// exponentially.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

namespace wakesurf::server {

/// Not thread safe. Cost of every call: O(log sessions).
class RecentUse {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param memory  what was used so long ago counts for 1/e
    explicit RecentUse(std::chrono::milliseconds memory) : memory_(memory) {}

    void add(const std::string& session, double seconds, Time now);

    /// Returns the share of that time: 1 for a session that has used one thread all the time.
    double share(const std::string& session, Time now) const;

    /// Sessions whose share is more. Cost: O(sessions that have used anything lately).
    std::size_t busier_than(double share, Time now) const;

  private:
    struct Use {
        double seconds = 0.0;
        Time since{};
    };

    double at(const Use& use, Time now) const;
    void forget_idle(Time now);

    std::chrono::milliseconds memory_;
    std::map<std::string, Use> uses_;
    Time swept_{};
};

} // namespace wakesurf::server
