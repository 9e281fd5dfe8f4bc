#include "core/field/uniform_sampling.hpp"

#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_steps.hpp"

namespace wakesurf::core {

UniformSampling::UniformSampling(const UniformGrid& grid, const SolidMask& mask, Simd simd)
    : grid_(grid), mask_(mask), cells_(grid.dimensions, mask), kernel_(choose_rk4_kernel(simd)) {}

bool UniformSampling::advance(const Interval& interval,
                              const Particles& particles,
                              double to,
                              int sign,
                              const AdvanceOptions& options,
                              const std::stop_token& stop) const {
    const GridSampler<UniformGrid> field = linear(interval);
    if (!end_in_gaps(field, particles, to, sign, stop))
        return false;
    if (options.smooth) {
        const CubicSampler cubic = smooth(interval);
        return options.method == AdvanceOptions::Method::Rk4 && kernel_samples(cubic)
                   ? advance_stored(cubic, kernel_, particles, to, sign, options, stop)
                   : advance_particles(cubic, particles, to, sign, options, stop);
    }
    return options.method == AdvanceOptions::Method::Rk4
               ? advance_stored(field, kernel_, particles, to, sign, options, stop)
               : advance_particles(CellwiseSampler<UniformGrid>{field}, particles, to, sign,
                                   options, stop);
}

bool UniformSampling::sample_at(const Interval& interval,
                                std::span<const Vec3> positions,
                                double time,
                                std::span<Vec3f> velocities,
                                bool smoothly,
                                const std::stop_token& stop) const {
    if (smoothly) {
        const CubicSampler cubic = smooth(interval);
        return kernel_samples(cubic) &&
               sample_stored(cubic, kernel_, positions, time, velocities, stop);
    }
    const GridSampler<UniformGrid> field = linear(interval);
    return !field.gaps && sample_stored(field, kernel_, positions, time, velocities, stop);
}

bool UniformSampling::trace(const Interval& interval,
                            std::span<Curve> curves,
                            const TraceOptions& options,
                            double limit,
                            const std::stop_token& stop) const {
    const GridSampler<UniformGrid> field = linear(interval);
    if (!end_in_gaps(field, curves, stop))
        return false;
    return options.smooth
               ? trace_curves(smooth(interval), curves, options, limit, stop)
               : trace_curves(CellwiseSampler<UniformGrid>{field}, curves, options, limit, stop);
}

GridSampler<UniformGrid> UniformSampling::linear(const Interval& interval) const {
    return linear_sampler(grid_, cells_, mask_, interval);
}

CubicSampler UniformSampling::smooth(const Interval& interval) const {
    CubicSampler field{linear(interval)};
    field.gaps = field.linear.gaps;
    if (!mask_.empty()) {
        std::call_once(round_cells_made_,
                       [&] { round_cells_ = CellMask::round_cells(grid_.dimensions, mask_); });
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

} // namespace wakesurf::core
