// A flow: velocity over a domain and a time range, able to carry particles. Surfaces know flows only through
// this; grids, caches and closed forms are behind it.
#pragma once

#include "core/base/box.hpp"
#include "core/base/node_shares.hpp"
#include "core/base/point_status.hpp"
#include "core/base/result.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/field/between_times.hpp"
#include "core/integrate/curve.hpp"
#include "core/integrate/particles.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

namespace wakesurf::core {

class BrickCache;

/// The cost of tracing besides computing.
struct TraceCost {
    double load = 0.0; ///< s spent waiting for time-steps
};

/// The door to fields. Thread safety: concurrent calls are allowed.
class Flow {
  public:
    virtual ~Flow() = default;

    /// Round everything where the flow may be known.
    virtual Box domain() const = 0;

    /// Times at which the flow is known; nothing for closed forms, which are known at all times.
    virtual std::optional<std::array<double, 2>> time_range() const = 0;

    /// Times at which particles can be followed: those at which the flow is known, or any, if that is only one: it
    /// is the result of a steady solver, and the flow stands still.
    std::optional<std::array<double, 2>> time_bounds() const {
        const auto range = time_range();
        return range && (*range)[0] < (*range)[1] ? range : std::nullopt;
    }

    /// Returns the first stored time after `time`, or before it where `sign` is negative; nothing where there is
    /// none, and where the flow stands still. Between two of them the linear field at a place changes at a
    /// constant rate.
    virtual std::optional<double> next_stored_time(double /*time*/, double /*sign*/) const {
        return std::nullopt;
    }

    /// Returns the same field with every `stride`-th of its stored times, counted from the one before `from` both
    /// ways, and the first and the last; between them it is interpolated. Null for closed forms. It shares what
    /// is in memory, and may outlive this.
    virtual std::shared_ptr<const Flow> thinned(std::size_t /*stride*/, double /*from*/) const {
        return nullptr;
    }

    /// Returns the same field with another interpolation between its stored times; the same flow each time, as long
    /// as somebody holds it. Null for closed forms. It shares what is in memory, and may outlive this.
    virtual std::shared_ptr<const Flow> interpolated(Between /*between*/) const { return nullptr; }

    /// Returns the finest detail of the field, in units of length: the node spacing, or 1/100 of the shortest
    /// side for closed forms.
    virtual double finest_spacing() const = 0;

    /// Returns whether a place is in the fluid, in an obstacle, or outside.
    virtual PointStatus status(const Vec3& position) const = 0;

    /// The nodes the stored field's value at a point comes from.
    virtual NodeShares shares(const Vec3& position) const { return {status(position), 0, {}, {}}; }

    /// Returns the cache that fields over those nodes go through if they come brick by brick; null if they
    /// are had whole.
    virtual std::shared_ptr<BrickCache> bricks() const { return nullptr; }

    /// Integrates every curve from its seed to its end. Runs in parallel over curves in the caller's arena;
    /// the result does not depend on the number of threads.
    /// Error: Cancelled, OverLimit where `options.memory` is exhausted, or what loading a time-step reports.
    virtual Result<TraceCost>
    trace(std::span<Curve> curves, const TraceOptions& options, std::stop_token stop) const = 0;

    /// Carries every running particle from the time it has reached to `to`, tangents too where there are any.
    /// All of them move the same way in time. Runs in parallel; the result does not depend on the number of
    /// threads. A particle that ends stays at the place and time where it did. Error: Cancelled (particles
    /// are then at various times), or what loading a time-step reports.
    virtual Result<TraceCost> advance(const Particles& particles,
                                      double to,
                                      const AdvanceOptions& options,
                                      std::stop_token stop) const = 0;

    /// True when the data between two times are few (4 GiB): particles can be traced again from the one to
    /// the other at little cost, at none but computing where the memory holds them. Depends on these data
    /// alone, not on memory, and not on a series that grows.
    virtual bool few_data(double from, double to) const = 0;

    /// True where `smooth` means something other than linear: of stored data on a uniform grid. The others
    /// are sampled the same with both.
    virtual bool has_smooth() const { return false; }

    /// Says whether RK4 carries particles faster than the steps of controlled error of Method::Dopri5, but with
    /// errors that have to be checked: many at a time on uniform and rectilinear grids, and wherever the field is
    /// not linear between stored times, so that no series follows it cell by cell.
    virtual bool steps_in_batches() const { return false; }

    /// True when parts of the domain are solid.
    virtual bool obstacle() const = 0;

    /// Returns false if no wall reaches into a box that begins in the fluid, so that all of it is fluid. It
    /// is cheaper than a status where that is dear.
    virtual bool may_have_wall(const Box&) const { return obstacle(); }

    /// Returns false if no wall is met on the straight way between two places: either both or neither are in
    /// a solid.
    virtual bool may_cross_wall(const Vec3&, const Vec3&) const { return obstacle(); }

    /// Returns the solids for display, if the flow itself knows their shape; empty for stored data, whose
    /// store has it.
    virtual WallGeometry walls() const { return {}; }

    /// Samples the velocity at n points, each at its own time: the field's continuation outside the domain,
    /// zero inside obstacles of stored data.
    /// @param smooth  stored data: tricubic in space and cubic in time instead of linear
    /// Error: Cancelled, OutOfTime, or what loading a time-step reports.
    virtual Result<void> sample(std::span<const Vec3> positions,
                                std::span<const double> times,
                                std::span<Vec3> velocities,
                                std::stop_token stop,
                                bool smooth = false) const = 0;

    /// Sets gap[i] to 1 if a stored field has no velocity at a point's time: a node's that counts there is no
    /// finite number. Such points are outside the domain at that time, whatever status() says; sample()
    /// extrapolates there from the nodes near by. Others stay as they are. Cost: negligible for data without
    /// gaps. Error: as sample.
    virtual Result<void> mark_gaps(std::span<const Vec3> /*positions*/,
                                   std::span<const double> /*times*/,
                                   std::span<std::uint8_t> /*gap*/,
                                   std::stop_token /*stop*/) const {
        return {};
    }

    /// Samples the velocity at n points at one time in float. Where particles are carried in batches these
    /// are the kernel's samples, several times as fast and some 1e-6 of the speed from those of sample(),
    /// with the same bits as Particles::velocity.
    /// @param cell  as Particles::cell
    virtual Result<void> sample_at(std::span<const Vec3> positions,
                                   double time,
                                   std::span<Vec3f> velocities,
                                   std::stop_token stop,
                                   bool smooth = false,
                                   std::span<std::uint32_t> cell = {}) const;
};

} // namespace wakesurf::core
