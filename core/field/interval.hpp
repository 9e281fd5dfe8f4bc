// The time-steps of an interval between two stored times, kept while particles cross it.
#pragma once

#include "core/base/event_count.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/dataset/time_step_cache.hpp"

#include <memory>
#include <mutex>
#include <stop_token>

namespace wakesurf::core {

struct Interval {
    /// The time-step before the interval; null unless asked for, and at the start of the series.
    std::shared_ptr<const TimeStep> before;
    std::shared_ptr<const TimeStep> first;
    std::shared_ptr<const TimeStep> second; ///< null where one time-step is all that is needed
    std::shared_ptr<const TimeStep> after;  ///< null unless asked for, and at the end of the series
    std::shared_ptr<MissingBricks> missing{}; ///< null where the time-steps are in one piece
};

/// Loads intervals. Thread safety: concurrent calls are allowed.
class Intervals {
  public:
    enum class Needs {
        First, ///< for times at its start only
        Both,
        Four, ///< both ends and their neighbours: cubic in time
    };

    explicit Intervals(std::shared_ptr<TimeStepCache> cache);

    /// Returns the interval [times[k], times[k+1]]; REQUIRES that the caller owns none. Callers that between
    /// them hold what each still wants release it, and take turns; in a small cache they do so from the
    /// start. Error: as TimeStepCache::acquire.
    Result<Interval> acquire(std::size_t k, Needs needs, const std::stop_token& stop) const;

  private:
    Result<Interval> try_acquire(std::size_t k, Needs needs, const std::stop_token& stop) const;

    std::shared_ptr<TimeStepCache> cache_;
    bool tight_;
    mutable std::mutex mutex_;
    mutable EventCount turn_over_;
    mutable bool turn_taken_ = false;
};

} // namespace wakesurf::core
