// What becomes of a particle that is slower than what counts as moving. In a field that stands still it ends. Where
// the field changes it waits, because the fluid may move again: at slack water, or before a flow that starts from rest.
// Only one that a wall holds ends there as well: beside a body that holds the fluid, velocity falls to zero
// with the distance, and a particle on its way there slows down for ever and meets no face.
#pragma once

#include "core/base/vec3.hpp"
#include "core/integrate/curve.hpp"

#include <concepts>

namespace wakesurf::core {

/// The part of a cell within which a particle at rest has reached a wall.
inline constexpr double near_wall = 0.1;

/// A wall holds a particle whose speed is at most this part of its cell's: it is as near to the wall as that. At
/// slack water the cell comes to rest with the particle.
inline constexpr double held_part = 1e-3;

template <class F>
concept FieldWithWalls = requires(const F& field, const Vec3& p) {
    /// True where what is next to `p`, within `near_wall` of a cell, is a wall.
    { field.at_wall(p) } -> std::same_as<bool>;
};

template <class F>
concept FieldOfCells = requires(const F& field, const Vec3& p, double t) {
    /// The speed of the fastest node of the cell that `p` is in.
    { field.cell_speed(p, t) } -> std::same_as<double>;
};

template <class F>
concept SteadyField = requires {
    requires F::steady();
};

template <class F>
concept FieldOfTimeSteps = requires(const F& field) {
    /// True of one time-step alone: the field stands still.
    { field.stands_still() } -> std::same_as<bool>;
};

/// Returns whether a particle at rest ends, rather than wait. Closed forms have no cells: their walls always hold.
/// @param speed  of the particle, less than what counts as moving, or not a number
template <class Field>
bool ends_at_rest(const Field& field, const Vec3& p, double t, double speed, bool frozen) {
    if (frozen || SteadyField<Field> || !(speed >= 0.0))
        return true;
    if constexpr (FieldOfTimeSteps<Field>)
        if (field.stands_still())
            return true;
    if constexpr (FieldWithWalls<Field>) {
        if (!field.at_wall(p))
            return false;
        if constexpr (FieldOfCells<Field>)
            return speed < held_part * field.cell_speed(p, t);
        return true;
    }
    return false;
}

/// Returns the reason why one ends.
template <class Field>
CurveEnd end_at_rest(const Field& field, const Vec3& p) {
    if constexpr (FieldWithWalls<Field>) {
        if (field.at_wall(p))
            return CurveEnd::Obstacle;
    }
    return CurveEnd::Stagnation;
}

} // namespace wakesurf::core
