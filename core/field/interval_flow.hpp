// A stored field as a flow: time-steps come through the cache, interval by interval. A Sampling computes what
// happens within one.
#pragma once

#include "core/base/clock.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/advance_particles.hpp"
#include "core/field/flow.hpp"
#include "core/field/interval.hpp"
#include "core/field/other_interpolations.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

template <IntervalSampling Sampling>
class IntervalFlow final : public Flow {
    static constexpr std::size_t small_data_bytes = std::size_t{4} << 30;

  public:
    IntervalFlow(std::shared_ptr<TimeStepCache> cache,
                 std::shared_ptr<const Clock> clock,
                 std::shared_ptr<const Sampling> sampling,
                 std::vector<std::size_t> steps = {},
                 Between between = Between::Linear)
        : cache_(std::move(cache)), intervals_(cache_, std::move(steps), between),
          clock_(std::move(clock)), source_(cache_->source()), sampling_(std::move(sampling)),
          domain_(bounds(source_.grid())), finest_(core::finest_spacing(source_.grid())) {}

    Box domain() const override { return domain_; }

    std::optional<std::array<double, 2>> time_range() const override {
        return std::array{intervals_.times().front(), intervals_.times().back()};
    }

    std::optional<double> next_stored_time(double time, double sign) const override {
        return intervals_.next(time, sign);
    }

    std::shared_ptr<const Flow> thinned(std::size_t stride, double from) const override {
        return std::make_shared<IntervalFlow>(cache_, clock_, sampling_,
                                              intervals_.every(stride, intervals_.at(from)),
                                              intervals_.between());
    }

    std::shared_ptr<const Flow> interpolated(Between between) const override {
        return others_.get(between, [&] {
            return std::make_shared<IntervalFlow>(cache_, clock_, sampling_, intervals_.steps(),
                                                  between);
        });
    }

    double finest_spacing() const override { return finest_; }

    PointStatus status(const Vec3& position) const override { return sampling_->status(position); }

    NodeShares shares(const Vec3& position) const override { return sampling_->shares(position); }

    std::shared_ptr<BrickCache> bricks() const override { return cache_->bricks(); }

    Result<TraceCost> trace(std::span<Curve> curves,
                            const TraceOptions& options,
                            std::stop_token stop) const override {
        if (curves.empty())
            return TraceCost{};
        if (!options.frozen && !stands_still())
            return trace_intervals(curves, options, upstream(curves) ? -1 : +1, stop);
        const double release = curves.front().release;
        const auto start = clock_->now();
        const auto interval = frozen_interval(release, options.smooth, stop);
        if (!interval)
            return tl::unexpected(interval.error());
        const TraceCost cost{seconds_since(start)};
        return advance(*interval, curves, options, upstream(curves) ? -forever : forever, stop)
            .map([&] { return cost; });
    }

    Result<TraceCost> advance(const Particles& particles,
                              double to,
                              const AdvanceOptions& options,
                              std::stop_token stop) const override {
        const std::vector<double>& times = intervals_.times();
        TraceCost cost;
        double from = to;
        int direction = 0;
        for (std::size_t i = 0; i < particles.count(); ++i) {
            if (particles.end[i] != CurveEnd::Running || particles.time[i] == to)
                continue;
            direction = particles.time[i] < to ? +1 : -1;
            from = direction > 0 ? std::min(from, particles.time[i])
                                 : std::max(from, particles.time[i]);
        }
        if (direction == 0)
            return cost;
        std::vector<std::uint32_t> cell(particles.cell.empty() ? particles.count() : 0, no_cell);
        auto k = static_cast<std::ptrdiff_t>(intervals_.at(from));
        if (direction < 0 && k > 0 && times[static_cast<std::size_t>(k)] == from)
            --k;
        for (double reached = from; reached != to; from = reached, k += direction) {
            const auto index = static_cast<std::size_t>(k);
            const auto start = clock_->now();
            const auto interval =
                intervals_.acquire(index, steps_needed(true, options.smooth), stop);
            cost.load += seconds_since(start);
            if (!interval)
                return unreadable(interval.error(), index, direction, stop);
            prefetch(index, direction, options.smooth);
            // Time-steps end the interval, but not before `to` and not after the last of them.
            const double border =
                times[std::min(direction > 0 ? index + 1 : index, times.size() - 1)];
            const bool last =
                direction > 0 ? border >= to || k + 2 >= static_cast<std::ptrdiff_t>(times.size())
                              : border <= to || k == 0;
            reached = last ? to : border;
            if (interval->missing &&
                from == times[direction > 0 ? index : std::min(index + 1, times.size() - 1)])
                interval->missing->begins();
            Particles here = particles;
            if (!cell.empty()) // from interval to interval
                here.cell = cell;
            if (reached != to) { // a particle that dies later would keep the velocity at the border
                here.velocity = {};
                here.sampled = {};
            }
            const bool whole =
                sampling_->advance(*interval, here, reached, direction, options, stop);
            if (!whole && interval->missing && interval->missing->error())
                return unreadable(*interval->missing->error(), index, direction, stop);
            if (!whole)
                return fail(Error::Code::Cancelled, "the integration was cancelled");
        }
        return cost;
    }

    bool few_data(double from, double to) const override {
        // From the last time-step that is not later than both to the first that is not earlier.
        const std::vector<double>& times = intervals_.times();
        const auto first = std::upper_bound(times.begin(), times.end(), std::min(from, to));
        const auto last = std::lower_bound(times.begin(), times.end(), std::max(from, to));
        const auto before = first - times.begin() - (first == times.begin() ? 0 : 1);
        const auto behind = last - times.begin() + (last == times.end() ? 0 : 1);
        return source_.bytes_per_step() * static_cast<std::size_t>(behind - before) <=
               small_data_bytes;
    }

    bool has_smooth() const override { return Sampling::has_smooth; }

    bool steps_in_batches() const override {
        return Sampling::steps_in_batches || intervals_.between() != Between::Linear;
    }

    bool obstacle() const override { return sampling_->obstacle(); }

    bool may_have_wall(const Box& box) const override {
        if constexpr (requires { sampling_->may_have_wall(box); })
            return sampling_->may_have_wall(box);
        else
            return sampling_->obstacle();
    }

    bool may_cross_wall(const Vec3& from, const Vec3& to) const override {
        if constexpr (requires { sampling_->may_cross_wall(from, to); })
            return sampling_->may_cross_wall(from, to);
        else
            return sampling_->obstacle();
    }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double> times,
                        std::span<Vec3> velocities,
                        std::stop_token stop,
                        bool smoothly) const override {
        return by_interval(times, [&](std::span<const std::uint32_t> chosen) {
            return sample_interval(positions, times, velocities, chosen, stop, smoothly);
        });
    }

    Result<void> mark_gaps(std::span<const Vec3> positions,
                           std::span<const double> times,
                           std::span<std::uint8_t> gap,
                           std::stop_token stop) const override {
        return by_interval(times, [&](std::span<const std::uint32_t> chosen) {
            return mark_gaps_of_interval(positions, times, gap, chosen, stop);
        });
    }

    Result<void> sample_at(std::span<const Vec3> positions,
                           double time,
                           std::span<Vec3f> velocities,
                           std::stop_token stop,
                           bool smoothly,
                           std::span<std::uint32_t> cell) const override {
        if constexpr (requires { &Sampling::sample_at; }) {
            const std::size_t k = intervals_.at(time);
            const auto held =
                intervals_.acquire(k, steps_needed(time > intervals_.times()[k], smoothly), stop);
            if (!held)
                return tl::unexpected(held.error());
            if (sampling_->sample_at(*held, positions, time, velocities, smoothly, stop))
                return {};
            if (stop.stop_requested() || (held->missing && held->missing->error()))
                return result_of(false, *held);
        }
        const std::vector<double> times(positions.size(), time);
        std::vector<Vec3> exact(positions.size());
        return sample_interval(positions, times, exact, {}, stop, smoothly, cell).map([&] {
            std::copy(exact.begin(), exact.end(), velocities.begin());
        });
    }

  private:
    /// Calls `use(chosen)` with the points of every interval in the order of time, so that the window slides
    /// once over the data. Empty: all.
    template <class Use>
    Result<void> by_interval(std::span<const double> times, const Use& use) const {
        const auto [first, last] = std::minmax_element(times.begin(), times.end());
        if (times.empty() ||
            intervals_.at(*first) == intervals_.at(*last)) // a moment: the usual case
            return use({});
        std::vector<std::uint32_t> interval(times.size());
        std::transform(times.begin(), times.end(), interval.begin(), [&](double time) {
            return static_cast<std::uint32_t>(intervals_.at(time));
        });
        std::vector<std::uint32_t> order(times.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](auto a, auto b) { return interval[a] < interval[b]; });
        for (std::size_t begin = 0; begin < order.size();) {
            std::size_t end = begin;
            while (end < order.size() && interval[order[end]] == interval[order[begin]])
                ++end;
            if (auto done = use(std::span<const std::uint32_t>(order.data() + begin, end - begin));
                !done)
                return done;
            begin = end;
        }
        return {};
    }

    /// Calls `use(interval, i)` for each of the points of an interval whose time-steps have gaps. The
    /// interval is cut to the one time-step that counts at the point's time where that is a stored one; a gap
    /// in the other is none then.
    template <class Use>
    Result<void> for_each_at_its_steps(const Interval& held,
                                       std::span<const double> times,
                                       std::span<const std::uint32_t> chosen,
                                       std::size_t count,
                                       const std::stop_token& stop,
                                       const Use& use) const {
        const Interval first{nullptr, held.first, nullptr, nullptr, held.missing};
        const Interval second{nullptr, held.second, nullptr, nullptr, held.missing};
        const auto use_points = [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k != end; ++k) {
                const std::size_t i = chosen.empty() ? k : chosen[k];
                if (times[i] == held.first->time)
                    use(first, i);
                else
                    use(held.second && times[i] == held.second->time ? second : held, i);
            }
        };
        const auto use_ranges = [&](std::size_t begin, std::size_t end) {
            const auto shifted = [&](std::size_t from, std::size_t to) {
                use_points(begin + from, begin + to);
            };
            return in_ranges(end - begin, {}, shifted, 1024);
        };
        return result_of(MissingBricks::in_rounds(held.missing.get(), count, stop,
                                                  MissingBricks::Again::Redo, use_ranges),
                         held);
    }

    /// Returns the error of something that has ended early, if it is not `whole`.
    static Result<void> result_of(bool whole, const Interval& held) {
        if (whole)
            return {};
        if (held.missing && held.missing->error())
            return tl::unexpected(*held.missing->error());
        return fail(Error::Code::Cancelled, "sampling was cancelled");
    }

    Result<Interval> interval_of(std::span<const double> times,
                                 std::span<const std::uint32_t> chosen,
                                 std::size_t count,
                                 const std::stop_token& stop,
                                 bool smoothly) const {
        const auto index = [&](std::size_t i) { return chosen.empty() ? i : chosen[i]; };
        const std::size_t k = intervals_.at(times[index(0)]);
        bool later = false;
        for (std::size_t i = 0; i < count; ++i)
            later = later || times[index(i)] > intervals_.times()[k];
        return intervals_.acquire(k, steps_needed(later, smoothly), stop);
    }

    static bool gaps_in(const Interval& held) {
        return held.first->gaps || (held.second && held.second->gaps);
    }

    Result<void> mark_gaps_of_interval(std::span<const Vec3> positions,
                                       std::span<const double> times,
                                       std::span<std::uint8_t> gap,
                                       std::span<const std::uint32_t> chosen,
                                       const std::stop_token& stop) const {
        const std::size_t count = chosen.empty() ? positions.size() : chosen.size();
        if (count == 0)
            return {};
        const auto held = interval_of(times, chosen, count, stop, false);
        if (!held)
            return tl::unexpected(held.error());
        if (!gaps_in(*held))
            return {};
        const auto mark_gap = [&](const Interval& steps, std::size_t i) {
            const BrickMisses misses(held->missing.get());
            const auto known = [&](std::size_t node) {
                const auto speed = [&](const TimeStep& step) { // finite where all three are
                    const float* v = velocity_at(step, node, misses);
                    return std::abs(double{v[0]}) + std::abs(double{v[1]}) + std::abs(double{v[2]});
                };
                return speed(*steps.first) + (steps.second ? speed(*steps.second) : 0.0);
            };
            const NodeShares shares = sampling_->shares(positions[i]);
            if (shares.status == PointStatus::Inside && std::isnan(weighed(shares, known)))
                gap[i] = 1;
        };
        return for_each_at_its_steps(*held, times, chosen, count, stop, mark_gap);
    }

    /// Points whose times fall into one interval. @param chosen which of them; empty: all
    Result<void> sample_interval(std::span<const Vec3> positions,
                                 std::span<const double> times,
                                 std::span<Vec3> velocities,
                                 std::span<const std::uint32_t> chosen,
                                 const std::stop_token& stop,
                                 bool smoothly,
                                 std::span<std::uint32_t> cell = {}) const {
        const std::size_t count = chosen.empty() ? positions.size() : chosen.size();
        if (count == 0)
            return {};
        const auto index = [&](std::size_t i) { return chosen.empty() ? i : chosen[i]; };
        const auto held = interval_of(times, chosen, count, stop, smoothly);
        if (!held)
            return tl::unexpected(held.error());
        std::vector<Vec3> brought_in;
        if constexpr (requires { sampling_->brought_in(positions); })
            positions = brought_in = sampling_->brought_in(positions);
        bool whole = true;
        sampling_->with_field(*held, smoothly, [&](const auto& field) {
            const auto sample_range = [&](const auto& view, std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i != end; ++i) {
                    restart(view, cell, i);
                    velocities[index(i)] = view.velocity(positions[index(i)], times[index(i)]);
                    keep_cell(view, cell, i);
                }
            };
            whole = in_blocks(field, count, stop, sample_range, 4096, MissingBricks::Again::Redo);
        });
        if (!whole || !gaps_in(*held))
            return result_of(whole, *held);
        const auto sample_stored_time = [&](const Interval& steps, std::size_t i) {
            if (held->second && !steps.second)
                sampling_->with_field(steps, smoothly, [&](const auto& field) {
                    velocities[i] = field.velocity(positions[i], times[i]);
                });
        };
        return for_each_at_its_steps(*held, times, chosen, count, stop, sample_stored_time);
    }

    /// Returns x, y and z at a node.
    static const float*
    velocity_at(const TimeStep& step, std::size_t node, const BrickMisses& misses) {
        if (!step.bricks)
            return step.velocity().data() + 3 * node;
        const BrickLayout::BrickNode place = misses.all()->layout().place_of(node);
        const float* brick = step.bricks->at(place.brick);
        return (brick != nullptr ? brick : misses.note(place.brick)) + 3 * place.node;
    }

    static constexpr double forever = std::numeric_limits<double>::infinity();

    static bool upstream(std::span<const Curve> curves) { return curves.front().duration < 0.0; }

    /// True of one stored time.
    bool stands_still() const { return intervals_.times().size() < 2; }

    Intervals::Needs steps_needed(bool both, bool smoothly) const {
        return !both || stands_still() ? Intervals::Needs::First
               : smoothly              ? Intervals::Needs::Four
                                       : Intervals::Needs::Both;
    }

    /// Returns the time-steps of a field frozen at `time`: one if the time is a stored one, else those round
    /// it.
    Result<Interval>
    frozen_interval(double time, bool smoothly, const std::stop_token& stop) const {
        const std::vector<double>& times = intervals_.times();
        const auto stored = std::find(times.begin(), times.end(), time);
        return stored != times.end()
                   ? intervals_.acquire(static_cast<std::size_t>(stored - times.begin()),
                                        Intervals::Needs::First, stop)
                   : intervals_.acquire(intervals_.at(time), steps_needed(true, smoothly), stop);
    }

    /// Loads ahead of what interval `k` holds, which stays: the next step may be in the same interval.
    void prefetch(std::size_t k, int direction, bool smoothly) const {
        const std::size_t last = intervals_.times().size() - 1;
        const std::size_t beyond = smoothly || intervals_.between() != Between::Linear ? 1 : 0;
        const std::size_t low = k - std::min(k, beyond);
        const std::size_t high = std::min(k + 1 + beyond, last);
        const std::size_t first = intervals_.step(low), behind = intervals_.step(high);
        cache_->prefetch(direction > 0 ? behind : first, direction, behind - first);
    }

    Result<void> advance(const Interval& interval,
                         std::span<Curve> curves,
                         const TraceOptions& options,
                         double limit,
                         const std::stop_token& stop) const {
        if (sampling_->trace(interval, curves, options, limit, stop))
            return {};
        if (interval.missing && interval.missing->error())
            return tl::unexpected(*interval.missing->error());
        return tl::unexpected(cut_short(options));
    }

    /// Returns the error with the time up to which the series can be read: to the end of the first interval,
    /// unless that is what is broken.
    tl::unexpected<Error> unreadable(Error error,
                                     std::size_t interval,
                                     int direction,
                                     const std::stop_token& stop) const {
        const std::size_t near =
            std::min(direction > 0 ? interval : interval + 1, intervals_.times().size() - 1);
        const bool broken = error.code == Error::Code::Corrupt || error.code == Error::Code::Io ||
                            error.code == Error::Code::NotFound;
        if (broken && intervals_.acquire(near, Intervals::Needs::First, stop))
            error.readable_until = intervals_.times()[near];
        return tl::unexpected(std::move(error));
    }

    /// Steps never straddle a stored time, where the field is only continuous.
    Result<TraceCost> trace_intervals(std::span<Curve> curves,
                                      const TraceOptions& options,
                                      int direction,
                                      const std::stop_token& stop) const {
        const std::vector<double>& times = intervals_.times();
        TraceCost cost;
        const double release = curves.front().release;
        auto k = static_cast<std::ptrdiff_t>(intervals_.at(release));
        if (direction < 0 && k > 0 && times[static_cast<std::size_t>(k)] == release)
            --k;
        const auto running = [](const Curve& curve) { return curve.end == CurveEnd::Running; };
        for (; k >= 0 && k + 1 < static_cast<std::ptrdiff_t>(times.size()); k += direction) {
            const auto index = static_cast<std::size_t>(k);
            const auto start = clock_->now();
            const auto interval =
                intervals_.acquire(index, steps_needed(true, options.smooth), stop);
            cost.load += seconds_since(start);
            if (!interval)
                return unreadable(interval.error(), index, direction, stop);
            prefetch(index, direction, options.smooth);
            if (interval->missing)
                interval->missing->begins();
            const double limit = times[direction > 0 ? index + 1 : index];
            if (auto done = advance(*interval, curves, options, limit, stop); !done)
                return interval->missing && interval->missing->error()
                           ? unreadable(done.error(), index, direction, stop)
                           : tl::unexpected(done.error());
            if (std::none_of(curves.begin(), curves.end(), running))
                break;
        }
        for (Curve& curve : curves)
            if (running(curve))
                curve.end = CurveEnd::Time;
        return cost;
    }

    double seconds_since(std::chrono::steady_clock::time_point start) const {
        return std::chrono::duration<double>(clock_->now() - start).count();
    }

    std::shared_ptr<TimeStepCache> cache_;
    Intervals intervals_;
    std::shared_ptr<const Clock> clock_;
    const TimeStepSource& source_;
    std::shared_ptr<const Sampling> sampling_;
    Box domain_;
    double finest_;
    OtherInterpolations others_;
};

} // namespace wakesurf::core
