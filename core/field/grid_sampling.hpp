// Samples a stored field on a uniform or rectilinear grid between two time-steps: linear, smooth, in
// batches of the vector kernel, or cell by cell, whichever serves. Only a uniform grid has a smooth field.
#pragma once

#include "core/field/advance_stored.hpp"
#include "core/field/cubic_sampler.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/field/stored_steps.hpp"

#include <concepts>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>

namespace wakesurf::core {

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
          kernel_(choose_rk4_kernel(simd)) {}

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
        use(linear(interval));
    }

  private:
    GridSampler<Axes> linear(const Interval& interval) const {
        return linear_sampler(axes_, cells_, mask_, interval);
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
};

using UniformSampling = GridSampling<UniformGrid>;
using RectilinearSampling = GridSampling<RectilinearAxes>;

} // namespace wakesurf::core
