// Samples a stored field on a uniform or rectilinear grid between two time-steps: linear, smooth, in
// batches of the vector kernel, or cell by cell, whichever serves; otherwise than linear in time, place by place. Only a uniform grid has a smooth field.
#pragma once

#include "core/field/advance_particles.hpp"
#include "core/field/advance_stored.hpp"
#include "core/field/between_sampler.hpp"
#include "core/field/cubic_sampler.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/interval.hpp"
#include "core/field/kernel/series_batch.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/integrate/curve.hpp"

#include <concepts>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Returns the sampler of an interval. @param interval  none of its time-steps: good for status only
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
    const auto end_points = [&](const auto& view, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i)
            if (still_to_go(particles, i, to, sign) &&
                view.status(particles.position[i]) == PointStatus::OutsideDomain &&
                !take_missed(view))
                particles.end[i] = CurveEnd::Domain;
    };
    return in_blocks(field, particles.count(), stop, end_points, 1024);
}

/// Prepares curves that have come some way; those that have not yet begun find out themselves.
template <class Grid>
bool end_in_gaps(const GridSampler<Grid>& field,
                 std::span<Curve> curves,
                 const std::stop_token& stop) {
    if (!field.gaps)
        return true;
    const auto end_curves = [&](const auto& view, std::size_t begin, std::size_t end) {
        for (Curve& curve : curves.subspan(begin, end - begin))
            if (curve.end == CurveEnd::Running && curve.attempts > 0 &&
                view.status(curve.last.position) == PointStatus::OutsideDomain &&
                !take_missed(view))
                curve.end = CurveEnd::Domain;
    };
    return in_blocks(field, curves.size(), stop, end_curves, 1024);
}

/// Samples on the grid of `Axes`: UniformGrid or RectilinearAxes. Thread safety: concurrent calls are fine.
/// Keeps a reference to the mask.
template <class Axes>
class GridSampling {
  public:
    static constexpr bool has_smooth = std::same_as<Axes, UniformGrid>;
    static constexpr bool steps_in_batches = true;

    /// @param grid  what the axes are made of
    template <class Grid>
    GridSampling(const Grid& grid, const SolidMask& mask, Simd simd)
        : axes_(grid), mask_(mask), cells_(nodes_along(axes_), mask),
          kernel_(choose_rk4_kernel(simd)), series_(series_kernel(simd)) {}

    /// Returns the status at no particular time.
    PointStatus status(const Vec3& position) const { return linear({}).status(position); }

    NodeShares shares(const Vec3& position) const { return linear({}).shares(position); }

    bool obstacle() const { return !mask_.empty(); }

    /// Carries what has not reached `to` there. Returns false if `stop` fired.
    /// @param sign  direction of time, +1 or -1
    bool advance(const Interval& interval,
                 const Particles& particles,
                 double to,
                 int sign,
                 const AdvanceOptions& options,
                 const std::stop_token& stop) const;

    /// Samples velocities at points at one time, as particles are carried. Returns false where they are not
    /// to be had here, or if `stop` fired.
    bool sample_at(const Interval& interval,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   bool smoothly,
                   const std::stop_token& stop) const;

    /// Traces running curves up to the simulation time `limit`. Returns false if `stop` fired.
    bool trace(const Interval& interval,
               std::span<Curve> curves,
               const TraceOptions& options,
               double limit,
               const std::stop_token& stop) const;

    /// Calls `use` with a sampler that has `velocity(position, time)`.
    template <class Use>
    void with_field(const Interval& interval, bool smoothly, const Use& use) const {
        if constexpr (has_smooth)
            if (smoothly)
                return use(smooth(interval));
        if (interval.linear())
            use(linear(interval));
        else
            use(between(interval));
    }

  private:
    GridSampler<Axes> linear(const Interval& interval) const {
        return linear_sampler(axes_, cells_, mask_, interval);
    }

    BetweenSampler<GridSampler<Axes>> between(const Interval& interval) const {
        return between_sampler(interval, axes_.bounds(),
                               [&](const Interval& steps) { return linear(steps); });
    }

    static std::array<std::uint32_t, 3> nodes_along(const Axes& axes) {
        if constexpr (has_smooth)
            return axes.dimensions;
        else
            return axes.dimensions();
    }

    CubicSampler smooth(const Interval& interval) const requires has_smooth;

    Axes axes_;
    const SolidMask& mask_;
    CellMask cells_;
    mutable std::once_flag round_cells_made_;
    /// Is made when the field is smooth for the first time.
    mutable std::optional<CellMask> round_cells_;
    Rk4Kernel kernel_;
    const SeriesKernel& series_;
};

using UniformSampling = GridSampling<UniformGrid>;
using RectilinearSampling = GridSampling<RectilinearAxes>;

} // namespace wakesurf::core
