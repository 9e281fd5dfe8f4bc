// How much faster work could be on more cores, from what one thread measures.
#pragma once

#include "core/base/loop_times.hpp"

#include <algorithm>
#include <chrono>
#include <span>
#include <vector>

namespace wakesurf::bench {

/// Returns the seconds that work takes by the clock on the wall.
template <class Work>
double wall_seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Where the time of work goes that one thread does: into loops that threads share, and into what waits for one.
struct Division {
    double work = 0.0, shared = 0.0; ///< seconds
    std::vector<core::LoopTimes::Taken> loops;

    void add(double seconds, std::span<const core::LoopTimes::Taken> more) {
        work += seconds;
        for (const auto& each : more)
            shared += each.seconds;
        loops.insert(loops.end(), more.begin(), more.end());
    }

    double serial() const { return work - shared; }

    /// The time on so many cores that all are as fast as one alone, which memory they share does not allow: a bound.
    double on_cores(double cores) const {
        double sum = serial();
        for (const auto& each : loops)
            sum += each.seconds / std::max(1.0, std::min(cores, each.tasks));
        return sum;
    }
};

} // namespace wakesurf::bench
