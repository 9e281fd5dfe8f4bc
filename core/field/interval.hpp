// The time-steps of an interval between two stored times, held while particles cross it, and what samples
// them.
#pragma once

#include "core/base/event_count.hpp"
#include "core/base/node_shares.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/between_times.hpp"
#include "core/integrate/particles.hpp"

#include <concepts>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

struct Interval {
    /// The time-step before the interval; null unless asked for, and at the start of the series.
    std::shared_ptr<const TimeStep> before;
    std::shared_ptr<const TimeStep> first;
    std::shared_ptr<const TimeStep> second; ///< null where one time-step is all that is needed
    std::shared_ptr<const TimeStep> after;  ///< null unless asked for, and at the end of the series
    std::shared_ptr<MissingBricks> missing{}; ///< null where the time-steps are in one piece
    Between between = Between::Linear;        ///< Linear of one time-step

    bool linear() const { return between == Between::Linear; }
};

/// Loads intervals. Thread safety: concurrent calls are allowed.
class Intervals {
  public:
    enum class Needs {
        First, ///< for times at its start only
        Both,
        Four, ///< both ends and their neighbours: cubic in time
    };

    /// @param between  how the field goes between the time-steps; other than linearly, Both are Four
    /// @param steps  the time-steps of the series that count, ascending: others are skipped, and the field is
    /// interpolated between these; empty: all
    explicit Intervals(std::shared_ptr<TimeStepCache> cache,
                       std::vector<std::size_t> steps = {},
                       Between between = Between::Linear);

    /// Returns the times of the steps that count.
    const std::vector<double>& times() const { return times_; }

    Between between() const { return between_; }

    /// Returns the k of the interval [times()[k], times()[k + 1]] that a time falls into; the last one takes the end.
    std::size_t at(double time) const;

    /// Returns the first of the times after `time`, or before it where `sign` is negative; nothing where there is
    /// none, and where there is but one.
    std::optional<double> next(double time, double sign) const;

    /// Returns the numbers of the steps that count.
    const std::vector<std::size_t>& steps() const { return steps_; }

    /// Returns the number of the k-th step that counts in the series.
    std::size_t step(std::size_t k) const { return steps_[k]; }

    /// Returns the numbers of every `stride`-th of the steps, counted both ways from the k-th, and of the first and
    /// the last.
    std::vector<std::size_t> every(std::size_t stride, std::size_t k) const;

    /// Returns the interval [times()[k], times()[k + 1]]; REQUIRES that the caller owns none. Callers that between
    /// them hold what each still wants release it, and take turns; in a small cache they do so from the
    /// start. Error: as TimeStepCache::acquire.
    Result<Interval> acquire(std::size_t k, Needs needs, const std::stop_token& stop) const;

  private:
    Result<Interval> try_acquire(std::size_t k, Needs needs, const std::stop_token& stop) const;

    std::shared_ptr<TimeStepCache> cache_;
    std::vector<std::size_t> steps_;
    std::vector<double> times_;
    Between between_;
    bool tight_;
    mutable std::mutex mutex_;
    mutable EventCount turn_over_;
    mutable bool turn_taken_ = false;
};

/// Samples the grid of a series within an interval of its time-steps. `advance` and `trace` return false
/// where they were stopped, or a brick could not be read. Optional members, each found by `requires`:
/// sample_at, may_have_wall, may_cross_wall, brought_in.
template <class S>
concept IntervalSampling = requires(const S& sampling,
                                    const Interval& interval,
                                    const Vec3& position,
                                    const Particles& particles,
                                    const AdvanceOptions& advance,
                                    std::span<Curve> curves,
                                    const TraceOptions& trace,
                                    const std::stop_token& stop) {
    { S::has_smooth } -> std::convertible_to<bool>;
    { S::steps_in_batches } -> std::convertible_to<bool>;
    { sampling.status(position) } -> std::same_as<PointStatus>;
    { sampling.shares(position) } -> std::same_as<NodeShares>;
    { sampling.obstacle() } -> std::same_as<bool>;
    { sampling.advance(interval, particles, 0.0, +1, advance, stop) } -> std::same_as<bool>;
    { sampling.trace(interval, curves, trace, 0.0, stop) } -> std::same_as<bool>;
    sampling.with_field(interval, false, [](const auto&) {});
};

} // namespace wakesurf::core
