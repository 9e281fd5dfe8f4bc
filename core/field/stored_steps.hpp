// The time-steps of an interval as a sampler's, and what ends before it starts: particles where the new time-step has no
// velocity.
#pragma once

#include "core/field/advance_particles.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/interval.hpp"
#include "core/integrate/curve.hpp"

#include <span>

namespace wakesurf::core {

/// @param interval  none of its time-steps: good for status only
template <class Grid>
GridSampler<Grid> linear_sampler(const Grid& grid,
                                 const CellMask& cells,
                                 const SolidMask& mask,
                                 const Interval& interval) {
    GridSampler<Grid> field{&grid, &cells, &mask, nullptr, nullptr};
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

/// Ends the particles on their way to `to` that lie in a gap of the interval.
template <class Grid>
void end_in_gaps(const GridSampler<Grid>& field, const Particles& particles, double to, int sign) {
    if (!field.gaps)
        return;
    for (std::size_t i = 0; i < particles.count(); ++i)
        if (still_to_go(particles, i, to, sign) &&
            field.status(particles.position[i]) == PointStatus::OutsideDomain)
            particles.end[i] = CurveEnd::Domain;
}

/// The same for curves that have come some way; those that have not yet begun find out themselves.
template <class Grid>
void end_in_gaps(const GridSampler<Grid>& field, std::span<Curve> curves) {
    if (!field.gaps)
        return;
    for (Curve& curve : curves)
        if (curve.end == CurveEnd::Running && !curve.steps.empty() &&
            field.status(curve.last.position) == PointStatus::OutsideDomain)
            curve.end = CurveEnd::Domain;
}

} // namespace wakesurf::core
