#include "core/field/grid_sampling.hpp"

#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_steps.hpp"

namespace wakesurf::core {

template <class Axes>
bool GridSampling<Axes>::advance(const Interval& interval,
                                 const Particles& particles,
                                 double to,
                                 int sign,
                                 const AdvanceOptions& options,
                                 const std::stop_token& stop) const {
    const GridSampler<Axes> field = linear(interval);
    if (!end_in_gaps(field, particles, to, sign, stop))
        return false;
    const bool rk4 = options.method == AdvanceOptions::Method::Rk4;
    if constexpr (has_smooth)
        if (options.smooth) {
            const CubicSampler cubic = smooth(interval);
            return rk4 && kernel_samples(cubic)
                       ? advance_stored(cubic, kernel_, particles, to, sign, options, stop)
                       : advance_particles(cubic, particles, to, sign, options, stop);
        }
    if (!interval.linear())
        return advance_particles(between(interval), particles, to, sign, options, stop);
    return rk4 ? advance_stored(field, kernel_, particles, to, sign, options, stop)
               : advance_particles(CellwiseSampler<Axes>{field}, particles, to, sign, options,
                                   stop);
}

template <class Axes>
bool GridSampling<Axes>::sample_at(const Interval& interval,
                                   std::span<const Vec3> positions,
                                   double time,
                                   std::span<Vec3f> velocities,
                                   [[maybe_unused]] bool smoothly,
                                   const std::stop_token& stop) const {
    if constexpr (has_smooth)
        if (smoothly) {
            const CubicSampler cubic = smooth(interval);
            return kernel_samples(cubic) &&
                   sample_stored(cubic, kernel_, positions, time, velocities, stop);
        }
    const GridSampler<Axes> field = linear(interval);
    return !field.gaps && interval.linear() &&
           sample_stored(field, kernel_, positions, time, velocities, stop);
}

template <class Axes>
bool GridSampling<Axes>::trace(const Interval& interval,
                               std::span<Curve> curves,
                               const TraceOptions& options,
                               double limit,
                               const std::stop_token& stop) const {
    const GridSampler<Axes> field = linear(interval);
    if (!end_in_gaps(field, curves, stop))
        return false;
    if constexpr (has_smooth)
        if (options.smooth)
            return trace_curves(smooth(interval), curves, options, limit, stop);
    if (!interval.linear())
        return trace_curves(between(interval), curves, options, limit, stop);
    return trace_curves(CellwiseSampler<Axes>{field}, curves, options, limit, stop, series_);
}

template <class Axes>
CubicSampler GridSampling<Axes>::smooth(const Interval& interval) const requires has_smooth {
    CubicSampler field{linear(interval)};
    field.gaps = field.linear.gaps;
    if (!mask_.empty()) {
        std::call_once(round_cells_made_,
                       [&] { round_cells_ = CellMask::round_cells(axes_.dimensions, mask_); });
        field.round_cells = &*round_cells_;
    }
    if (interval.before) {
        field.before = interval.before->nodes();
        field.time_before = interval.before->time;
        field.gaps = field.gaps || interval.before->gaps;
    }
    if (interval.after) {
        field.after = interval.after->nodes();
        field.time_after = interval.after->time;
        field.gaps = field.gaps || interval.after->gaps;
    }
    return field;
}

template class GridSampling<UniformGrid>;
template class GridSampling<RectilinearAxes>;

} // namespace wakesurf::core
