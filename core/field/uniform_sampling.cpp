#include "core/field/uniform_sampling.hpp"

#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_cell.hpp"

namespace wakesurf::core {

UniformSampling::UniformSampling(const TimeStepSource& source, Simd simd)
    : grid_(std::get<UniformGrid>(source.grid())), mask_(source.mask()), cells_(grid_, mask_),
      kernel_(choose_rk4_kernel(simd)) {}

bool UniformSampling::advance(const Interval& interval,
                              const Particles& particles,
                              double to,
                              int sign,
                              const AdvanceOptions& options,
                              const std::stop_token& stop) const {
    if (options.smooth)
        return advance_particles(smooth(interval), particles, to, sign, options, stop);
    const GridSampler field = linear(interval);
    return options.method == AdvanceOptions::Method::Rk4
               ? advance_stored(field, kernel_, particles, to, sign, options, stop)
               : advance_particles(field, particles, to, sign, options, stop);
}

bool UniformSampling::trace(const Interval& interval,
                            std::span<Curve> curves,
                            const TraceOptions& options,
                            double limit,
                            const std::stop_token& stop) const {
    return options.smooth
               ? trace_curves(smooth(interval), curves, options, limit, stop)
               : trace_curves(CellwiseSampler{linear(interval)}, curves, options, limit, stop);
}

NodeShares UniformSampling::shares(const Vec3& position) const {
    NodeShares shares{status(position), 0, {}, {}};
    if (shares.status != PointStatus::Inside)
        return shares;
    const Corners at = corners(grid_, locate(grid_, position));
    shares.count = 8;
    for (std::size_t i = 0; i < 8; ++i) {
        shares.node[i] = at.node[i];
        shares.share[i] = at.weight[i];
    }
    return shares;
}

GridSampler UniformSampling::linear(const Interval& interval) const {
    GridSampler field{&grid_, &cells_, &mask_, nullptr, nullptr, 0.0, 1.0};
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

CubicSampler UniformSampling::smooth(const Interval& interval) const {
    CubicSampler field{linear(interval)};
    if (interval.before) {
        field.before = interval.before->velocity().data();
        field.time_before = interval.before->time;
    }
    if (interval.after) {
        field.after = interval.after->velocity().data();
        field.time_after = interval.after->time;
    }
    return field;
}

} // namespace wakesurf::core
