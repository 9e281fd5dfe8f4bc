// Contenders timed in turn, A B C A B C, in one process: a machine's speed drifts by 20 % within seconds, so
// only ratios of medians taken side by side mean anything (docs/measurements.md, How to compare two
// programs). All work on one core, in the calling thread, whose CPU time is what counts: other programs on
// the machine then cost nothing but cache.
#pragma once

#include <algorithm>
#include <ctime>
#include <functional>
#include <vector>

namespace wakesurf::bench {

struct Timed {
    double median = 0.0; ///< s of CPU
    double spread = 0.0; ///< (slowest - fastest) / median
};

/// Returns the CPU time of the calling thread.
inline double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns the CPU seconds of one call.
template <class Work>
double seconds_of(const Work& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

inline Timed summarize(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    const double median = seconds[seconds.size() / 2];
    return {median, (seconds.back() - seconds.front()) / median};
}

/// One contender: does its work once and returns the seconds that count, preparation excluded.
using Turn = std::function<double()>;

/// Runs every contender once untimed, then `repetitions` rounds of all.
inline std::vector<Timed> interleave(const std::vector<Turn>& contenders, int repetitions) {
    std::vector<std::vector<double>> seconds(contenders.size());
    for (int round = -1; round < repetitions; ++round)
        for (std::size_t i = 0; i < contenders.size(); ++i)
            if (const double taken = contenders[i](); round >= 0)
                seconds[i].push_back(taken);
    std::vector<Timed> all;
    for (auto& each : seconds)
        all.push_back(summarize(std::move(each)));
    return all;
}

} // namespace wakesurf::bench
