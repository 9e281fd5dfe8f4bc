#include "core/field/rectilinear_sampling.hpp"

#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_steps.hpp"

namespace wakesurf::core {

RectilinearSampling::RectilinearSampling(const RectilinearGrid& grid,
                                         const SolidMask& mask,
                                         Simd simd)
    : axes_(grid), mask_(mask), cells_(axes_.dimensions(), mask), kernel_(choose_rk4_kernel(simd)) {
}

bool RectilinearSampling::advance(const Interval& interval,
                                  const Particles& particles,
                                  double to,
                                  int sign,
                                  const AdvanceOptions& options,
                                  const std::stop_token& stop) const {
    const GridSampler<RectilinearAxes> field = linear(interval);
    if (!end_in_gaps(field, particles, to, sign, stop))
        return false;
    return options.method == AdvanceOptions::Method::Rk4
               ? advance_stored(field, kernel_, particles, to, sign, options, stop)
               : advance_particles(CellwiseSampler<RectilinearAxes>{field}, particles, to, sign,
                                   options, stop);
}

bool RectilinearSampling::sample_at(const Interval& interval,
                                    std::span<const Vec3> positions,
                                    double time,
                                    std::span<Vec3f> velocities,
                                    bool /*smoothly*/,
                                    const std::stop_token& stop) const {
    const GridSampler<RectilinearAxes> field = linear(interval);
    return !field.gaps && sample_stored(field, kernel_, positions, time, velocities, stop);
}

bool RectilinearSampling::trace(const Interval& interval,
                                std::span<Curve> curves,
                                const TraceOptions& options,
                                double limit,
                                const std::stop_token& stop) const {
    const GridSampler<RectilinearAxes> field = linear(interval);
    if (!end_in_gaps(field, curves, stop))
        return false;
    return trace_curves(CellwiseSampler<RectilinearAxes>{field}, curves, options, limit, stop);
}

} // namespace wakesurf::core
