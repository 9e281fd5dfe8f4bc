#include "core/field/cells/cell_sampling.hpp"

#include "core/field/advance_particles.hpp"
#include "core/field/trace_curves.hpp"

namespace wakesurf::core {

bool CellSampling::advance(const Interval& interval,
                           const Particles& particles,
                           double to,
                           int sign,
                           const AdvanceOptions& options,
                           const std::stop_token& stop) const {
    return advance_particles(field(interval), particles, to, sign, options, stop);
}

bool CellSampling::trace(const Interval& interval,
                         std::span<Curve> curves,
                         const TraceOptions& options,
                         double limit,
                         const std::stop_token& stop) const {
    return trace_curves(field(interval), curves, options, limit, stop);
}

CellSampler CellSampling::field(const Interval& interval) const {
    CellSampler field{&domain_, nullptr, nullptr};
    if (interval.first) {
        field.velocity0 = interval.first->velocity().data();
        field.time0 = interval.first->time;
        field.gaps = interval.first->gaps;
    }
    if (interval.second) {
        field.velocity1 = interval.second->velocity().data();
        field.interval = interval.second->time - interval.first->time;
        field.gaps = field.gaps || interval.second->gaps;
    }
    return field;
}

} // namespace wakesurf::core
