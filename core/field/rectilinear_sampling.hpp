// Samples a stored field on a rectilinear grid between two time-steps: as on a uniform one, but for the
// smooth field, which is trilinear here.
#pragma once

#include "core/field/advance_stored.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/field/stored_steps.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Samples a rectilinear grid. Thread safety: concurrent calls are allowed. Keeps references to grid and
/// mask. Twin: uniform_sampling.hpp.
class RectilinearSampling {
  public:
    static constexpr bool has_smooth = false;
    static constexpr bool steps_in_batches = true;

    RectilinearSampling(const RectilinearGrid& grid, const SolidMask& mask, Simd simd);

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

    /// Velocities at points at one time, as particles are carried. False: not to be had here, or `stop`
    /// fired.
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
    void with_field(const Interval& interval, bool /*smoothly*/, const Use& use) const {
        use(linear(interval));
    }

  private:
    GridSampler<RectilinearAxes> linear(const Interval& interval) const {
        return linear_sampler(axes_, cells_, mask_, interval);
    }

    RectilinearAxes axes_;
    const SolidMask& mask_;
    CellMask cells_;
    Rk4Kernel kernel_;
};

} // namespace wakesurf::core
