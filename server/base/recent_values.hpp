// Quantiles of recent observations: a ring of the newest values with their times. Exact over what it holds,
// unlike a histogram's buckets, and it forgets, unlike a histogram.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace wakesurf::server {

struct Quantiles {
    double p50 = 0.0, p95 = 0.0, p99 = 0.0;
    std::uint64_t count = 0; ///< number of values; if 0, the others mean nothing
};

/// Holds recent values. Thread-safe.
class RecentValues {
  public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::size_t most = 1024;
    static constexpr std::chrono::seconds window{60};

    void add(Time now, double value);

    /// Returns nearest-rank quantiles of the newest `most` values no older than `window`. Cost: sorting them.
    Quantiles quantiles(Time now) const;

  private:
    struct Value {
        Time at;
        float value;
    };

    mutable std::mutex mutex_;
    std::array<Value, most> values_{};
    std::uint64_t added_ = 0;
};

} // namespace wakesurf::server
