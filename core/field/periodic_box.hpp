// The box of a flow that repeats: which period of it a place is in, and how a particle crosses its sides.
#pragma once

#include "core/base/periodic_axes.hpp"

#include <cstdint>
#include <optional>

namespace wakesurf::core {

/// Counts periods along x, y and z from the box on.
using Periods = std::array<std::int8_t, 3>;

/// A place on the way of a particle: in the box, and so many periods away from it.
struct PeriodicPlace {
    Vec3 in_box{0.0};
    Periods periods{0, 0, 0};
};

/// Where a particle ended on sides of the box, and what has been tried to get on from there.
struct SideCrossing {
    PeriodicPlace from;
    unsigned sides = 0; ///< a bit for each axis
    int tried = 0;
};

class PeriodicBox {
  public:
    PeriodicBox(const Box& box, const PeriodicAxes& axes) : box_(box), axes_(axes) {}

    /// Places beyond `periods_beyond` are left outside of the box.
    PeriodicPlace place_of(const Vec3& position) const;

    Vec3 shift(const Periods& periods) const;

    /// Returns the crossing of a particle that has ended at a place; nothing if that is on no periodic side.
    std::optional<SideCrossing> crossing_at(const PeriodicPlace& place) const;

    /// Says whether a particle that has ended again has not left the place of the crossing.
    bool still_there(const SideCrossing& crossing, const PeriodicPlace& place) const;

    /// Returns the next place to go on from: on the opposite sides of all axes first, as most cross, then of
    /// some, for a particle in an edge or in a corner that crosses only one of the sides there, and at last
    /// of none, for one that rounding has put beyond the side. Nothing where no more are left.
    std::optional<PeriodicPlace> across(SideCrossing& crossing) const;

  private:
    unsigned sides_at(const Vec3& in_box) const;

    bool low(const Vec3& in_box, int axis) const {
        return in_box[axis] < 0.5 * (box_.lo[axis] + box_.hi[axis]);
    }

    Box box_;
    PeriodicAxes axes_;
};

} // namespace wakesurf::core
