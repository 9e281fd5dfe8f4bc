// The time-steps of an interval as a sampler's, and what ends before it starts: particles where the new
// time-step has no velocity.
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
    GridSampler<Grid> field{&grid,
                            &cells,
                            &mask,
                            nullptr,
                            nullptr,
                            0.0,
                            1.0,
                            false,
                            interval.missing ? &interval.missing->layout() : nullptr,
                            BrickMisses(interval.missing.get())};
    if (interval.first) {
        field.velocity0 = interval.first->nodes();
        field.time0 = interval.first->time;
        field.gaps = interval.first->gaps;
    }
    if (interval.second) {
        field.velocity1 = interval.second->nodes();
        field.interval = interval.second->time - interval.first->time;
        field.gaps = field.gaps || interval.second->gaps;
    }
    return field;
}

/// Ends the particles on their way to `to` that lie in a gap of the interval. Returns false if `stop` fired.
template <class Grid>
bool end_in_gaps(const GridSampler<Grid>& field,
                 const Particles& particles,
                 double to,
                 int sign,
                 const std::stop_token& stop) {
    if (!field.gaps)
        return true;
    const auto some = [&](const auto& view, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i)
            if (still_to_go(particles, i, to, sign) &&
                view.status(particles.position[i]) == PointStatus::OutsideDomain &&
                !take_missed(view))
                particles.end[i] = CurveEnd::Domain;
    };
    return in_blocks(field, particles.count(), stop, some, 1024);
}

/// Prepares curves that have come some way; those that have not yet begun find out themselves.
template <class Grid>
bool end_in_gaps(const GridSampler<Grid>& field,
                 std::span<Curve> curves,
                 const std::stop_token& stop) {
    if (!field.gaps)
        return true;
    const auto some = [&](const auto& view, std::size_t begin, std::size_t end) {
        for (Curve& curve : curves.subspan(begin, end - begin))
            if (curve.end == CurveEnd::Running && curve.attempts > 0 &&
                view.status(curve.last.position) == PointStatus::OutsideDomain &&
                !take_missed(view))
                curve.end = CurveEnd::Domain;
    };
    return in_blocks(field, curves.size(), stop, some, 1024);
}

} // namespace wakesurf::core
