#include "core/field/grid_flow.hpp"

#include "core/field/advance_particles.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_cell.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

namespace wakesurf::core {

CellMask::CellMask(const UniformGrid& grid, const SolidMask& mask) {
    if (mask.empty())
        return;
    state_.assign(grid.nodes(), Fluid);
    for (std::uint32_t z = 0; z + 1 < grid.dimensions[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < grid.dimensions[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < grid.dimensions[0]; ++x) {
                const std::size_t node =
                    (std::size_t{z} * grid.dimensions[1] + y) * grid.dimensions[0] + x;
                int fluid = 0;
                for (const std::size_t corner : corners(grid, {node, Vec3(0.0)}).node)
                    fluid += mask.fluid[corner] != 0;
                state_[node] = fluid == 8 ? Fluid : fluid == 0 ? Solid : Mixed;
            }
}

namespace {

using StepPtr = std::shared_ptr<const TimeStep>;

/// The time-steps at both ends of an interval, held while particles cross it.
struct Interval {
    StepPtr first;
    StepPtr second; ///< null where one time-step is all that is needed
};

class GridFlow final : public Flow {
  public:
    GridFlow(std::shared_ptr<TimeStepCache> cache, std::shared_ptr<const Clock> clock)
        : cache_(std::move(cache)), clock_(std::move(clock)), source_(cache_->source()),
          cells_(source_.grid(), source_.mask()) {}

    Box domain() const override { return source_.grid().bounds(); }

    std::optional<std::array<double, 2>> time_range() const override {
        return std::array{source_.times().front(), source_.times().back()};
    }

    double finest_spacing() const override {
        const Vec3 h = source_.grid().spacing;
        return std::min({h.x, h.y, h.z});
    }

    PointStatus status(const Vec3& position) const override { return sampler({}).status(position); }

    Result<TraceCost> trace(std::span<Curve> curves,
                            const TraceOptions& options,
                            std::stop_token stop) const override {
        if (curves.empty())
            return TraceCost{};
        if (!options.frozen)
            return trace_intervals(curves, options, upstream(curves) ? -1 : +1, stop);
        const double release = curves.front().release;
        const auto start = clock_->now();
        const auto interval = frozen_interval(release, stop);
        if (!interval)
            return tl::unexpected(interval.error());
        const TraceCost cost{seconds_since(start)};
        return advance(*interval, curves, options, upstream(curves) ? -infinite : infinite, stop)
            .map([&] { return cost; });
    }

    Result<TraceCost> advance(const Particles& particles,
                              double to,
                              const AdvanceOptions& options,
                              std::stop_token stop) const override {
        const std::vector<double>& times = source_.times();
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
        auto k = static_cast<std::ptrdiff_t>(interval_at(from));
        if (direction < 0 && k > 0 && times[static_cast<std::size_t>(k)] == from)
            --k;
        for (double reached = from; reached != to; k += direction) {
            const auto index = static_cast<std::size_t>(k);
            const auto start = clock_->now();
            const auto interval = acquire(index, true, stop);
            cost.load += seconds_since(start);
            if (!interval)
                return tl::unexpected(interval.error());
            cache_->prefetch(direction > 0 ? index + 1 : index, direction);
            // Time-steps end the interval, but not before `to` and not after the last of them.
            const double border =
                times[std::min(direction > 0 ? index + 1 : index, times.size() - 1)];
            const bool last =
                direction > 0 ? border >= to || k + 2 >= static_cast<std::ptrdiff_t>(times.size())
                              : border <= to || k == 0;
            reached = last ? to : border;
            if (!advance_particles(sampler(*interval), particles, reached, direction, options,
                                   stop))
                return fail(Error::Code::Cancelled, "the integration was cancelled");
        }
        return cost;
    }

    bool resident() const override {
        return cache_->status().budget >= source_.bytes_per_step() * source_.times().size();
    }

    bool obstacle() const override { return !source_.mask().empty(); }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double> times,
                        std::span<Vec3> velocities,
                        std::stop_token stop) const override {
        // Interval by interval in time order, so that the window slides once over the data.
        std::vector<std::uint32_t> order(positions.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto interval_of = [&](std::uint32_t i) { return interval_at(times[i]); };
        const bool one_time =
            std::equal(times.begin() + !times.empty(), times.end(), times.begin());
        if (!one_time)
            std::stable_sort(order.begin(), order.end(),
                             [&](auto a, auto b) { return interval_of(a) < interval_of(b); });
        for (std::size_t begin = 0; begin < order.size();) {
            const std::size_t k = interval_of(order[begin]);
            std::size_t end = begin;
            bool later = false;
            for (; end < order.size() && (one_time || interval_of(order[end]) == k); ++end)
                later = later || times[order[end]] > source_.times()[k];
            const auto interval = acquire(k, later, stop);
            if (!interval)
                return tl::unexpected(interval.error());
            const GridSampler field = sampler(*interval);
            tbb::this_task_arena::isolate([&] {
                tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 4096),
                                  [&](const auto& range) {
                                      for (std::size_t i = range.begin(); i != range.end(); ++i)
                                          velocities[order[i]] =
                                              field.velocity(positions[order[i]], times[order[i]]);
                                  });
            });
            begin = end;
        }
        return {};
    }

  private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    static bool upstream(std::span<const Curve> curves) { return curves.front().duration < 0.0; }

    /// Index k of the interval [times[k], times[k+1]] a time falls into; the last one takes the end.
    std::size_t interval_at(double time) const {
        const std::vector<double>& times = source_.times();
        const auto after = std::upper_bound(times.begin(), times.end(), time);
        const auto index =
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - times.begin() - 1, 0));
        return std::min(index, times.size() < 2 ? 0 : times.size() - 2);
    }

    Result<Interval> acquire(std::size_t k, bool both, const std::stop_token& stop) const {
        auto first = cache_->acquire(k, stop);
        if (!first)
            return tl::unexpected(first.error());
        if (!both || k + 1 >= source_.times().size())
            return Interval{std::move(*first), nullptr};
        auto second = cache_->acquire(k + 1, stop);
        if (!second)
            return tl::unexpected(second.error());
        return Interval{std::move(*first), std::move(*second)};
    }

    /// What a field frozen at `time` needs: one time-step if the time is a stored one, else the pair round it.
    Result<Interval> frozen_interval(double time, const std::stop_token& stop) const {
        const std::vector<double>& times = source_.times();
        const auto stored = std::find(times.begin(), times.end(), time);
        return stored != times.end()
                   ? acquire(static_cast<std::size_t>(stored - times.begin()), false, stop)
                   : acquire(interval_at(time), true, stop);
    }

    GridSampler sampler(const Interval& interval) const {
        GridSampler field{&source_.grid(), &cells_, &source_.mask(), nullptr, nullptr, 0.0, 1.0};
        if (interval.first) {
            field.velocity0 = interval.first->velocity().data();
            field.time0 = interval.first->time;
        }
        if (interval.second) {
            field.velocity1 = interval.second->velocity().data();
            field.interval = interval.second->time - interval.first->time;
        }
        return field;
    }

    Result<void> advance(const Interval& interval,
                         std::span<Curve> curves,
                         const TraceOptions& options,
                         double limit,
                         const std::stop_token& stop) const {
        if (!trace_curves(CellwiseSampler{sampler(interval)}, curves, options, limit, stop))
            return fail(Error::Code::Cancelled, "the integration was cancelled");
        return {};
    }

    /// Steps never straddle a stored time, where the field is only continuous.
    Result<TraceCost> trace_intervals(std::span<Curve> curves,
                                      const TraceOptions& options,
                                      int direction,
                                      const std::stop_token& stop) const {
        const std::vector<double>& times = source_.times();
        TraceCost cost;
        const double release = curves.front().release;
        auto k = static_cast<std::ptrdiff_t>(interval_at(release));
        if (direction < 0 && k > 0 && times[static_cast<std::size_t>(k)] == release)
            --k;
        const auto running = [](const Curve& curve) { return curve.end == CurveEnd::Running; };
        for (; k >= 0 && k + 1 < static_cast<std::ptrdiff_t>(times.size()); k += direction) {
            const auto index = static_cast<std::size_t>(k);
            const auto start = clock_->now();
            const auto interval = acquire(index, true, stop);
            cost.load += seconds_since(start);
            if (!interval)
                return tl::unexpected(interval.error());
            cache_->prefetch(direction > 0 ? index + 1 : index, direction);
            const double limit = times[direction > 0 ? index + 1 : index];
            if (auto done = advance(*interval, curves, options, limit, stop); !done)
                return tl::unexpected(done.error());
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
    std::shared_ptr<const Clock> clock_;
    const TimeStepSource& source_;
    CellMask cells_;
};

} // namespace

std::unique_ptr<Flow> make_grid_flow(std::shared_ptr<TimeStepCache> cache,
                                     std::shared_ptr<const Clock> clock) {
    return std::make_unique<GridFlow>(std::move(cache), std::move(clock));
}

} // namespace wakesurf::core
