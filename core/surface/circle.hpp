// The circle of a rake of that kind, by its angle, and the longest arc of it inside a box.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <optional>

namespace wakesurf::core {

/// A circle, or an arc of it.
struct Circle {
    Vec3 centre; ///< of the circle
    Vec3 u;      ///< radius to where it begins
    Vec3 v;      ///< radius to a quarter of a turn further on

    /// Begins at `first`; `other` says which way it turns. REQUIRES: the three points do not lie on one line.
    Circle(const Vec3& centre, const Vec3& first, const Vec3& other);

    /// @param turn  0..1, once round; every point at the radius but for rounding
    Vec3 at(double turn) const;

    /// Returns the change of the place a turn, in units of length.
    Vec3 tangent(double turn) const;

    /// Returns the radius of the circle, in units of length.
    double radius() const { return glm::length(u); }
};

/// The beginning and end of an arc, in turns; the second is above 1 if the arc goes past the circle's
/// beginning. {0, 1} is the whole circle.
using Arc = std::array<double, 2>;

/// The longest part of a circle inside a box, its ends in it as well. Nothing: no part.
std::optional<Arc> longest_arc_inside(const Circle& circle, const Box& box);

} // namespace wakesurf::core
