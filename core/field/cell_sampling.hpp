// Samples a stored field on a mesh of cells between two time-steps, natively: each particle and each curve
// has a cursor of its own.
#pragma once

#include "core/base/node_shares.hpp"
#include "core/field/between_sampler.hpp"
#include "core/field/cells/cell_sampler.hpp"
#include "core/field/interval.hpp"
#include "core/integrate/curve.hpp"
#include "core/integrate/particles.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Offers IntervalFlow what GridSampling does. `smooth` changes nothing: the field of a mesh of cells is
/// what its shape functions give. Thread safety: concurrent calls are fine. It keeps a reference to the mesh.
class CellSampling {
  public:
    static constexpr bool has_smooth = false;
    static constexpr bool steps_in_batches = false;

    /// Builds the domain at the cost of CellDomain. @param box  round the domain
    CellSampling(const CellMesh& mesh, const Box& box) : domain_(mesh), box_(box) {}

    PointStatus status(const Vec3& position) const { return field({}).status(position); }

    NodeShares shares(const Vec3& position) const;

    bool obstacle() const { return !domain_.walls.empty(); }

    /// Round an axis walls are anywhere that one is.
    bool may_have_wall(const Box& box) const {
        return domain_.mesh.axis ? obstacle() : domain_.walls.near(box);
    }

    bool may_cross_wall(const Vec3& from, const Vec3& to) const {
        return domain_.mesh.axis ? obstacle() : domain_.walls.may_cross(from, to);
    }

    bool advance(const Interval& interval,
                 const Particles& particles,
                 double to,
                 int sign,
                 const AdvanceOptions& options,
                 const std::stop_token& stop) const;

    bool trace(const Interval& interval,
               std::span<Curve> curves,
               const TraceOptions& options,
               double limit,
               const std::stop_token& stop) const;

    template <class Use>
    void with_field(const Interval& interval, bool, const Use& use) const {
        if (interval.linear())
            use(field(interval));
        else
            use(between(interval));
    }

  private:
    CellSampler field(const Interval& interval) const;

    BetweenSampler<CellSampler> between(const Interval& interval) const;

    CellDomain domain_;
    Box box_;
};

} // namespace wakesurf::core
