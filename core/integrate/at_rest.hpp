// The reason why a particle at rest ends. Beside a body that holds the fluid, velocity falls to zero with the
// distance: a particle on its way there slows down for ever and meets no face. The wall has stopped it, so it
// ends like the particles that meet one.
#pragma once

#include "core/base/vec3.hpp"
#include "core/integrate/curve.hpp"

#include <concepts>

namespace wakesurf::core {

/// The part of a cell within which a particle at rest has reached a wall.
inline constexpr double near_wall = 0.1;

template <class F>
concept FieldWithWalls = requires(const F& field, const Vec3& p) {
    /// True where what is next to `p`, within `near_wall` of a cell, is a wall.
    { field.at_wall(p) } -> std::same_as<bool>;
};

/// Changes the reason alone, never where the particle is.
template <class Field>
CurveEnd end_at_rest(const Field& field, const Vec3& p) {
    if constexpr (FieldWithWalls<Field>) {
        if (field.at_wall(p))
            return CurveEnd::Obstacle;
    }
    return CurveEnd::Stagnation;
}

} // namespace wakesurf::core
