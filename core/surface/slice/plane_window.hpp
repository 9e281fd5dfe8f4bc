// Where a plane cuts a box, and the rectangle round that: the picture of a slice, with the directions that people expect.
#pragma once

#include "core/base/box.hpp"
#include "core/base/plane.hpp"
#include "core/base/result.hpp"

#include <vector>

namespace wakesurf::core {

/// A rectangle in space: corner + s across + t up, with s and t from 0 to 1.
struct PlaneWindow {
    Vec3 corner{0.0};
    Vec3 across{0.0}; ///< the whole lower side
    Vec3 up{0.0};     ///< the whole left side, at a right angle to it

    Vec3 at(double s, double t) const { return corner + s * across + t * up; }
};

/// Returns the corners of the polygon in which a plane cuts a box, in order round it; none where it misses the box. A plane
/// beyond a face by rounding is on that face.
std::vector<Vec3> plane_section(const Plane& plane, const Box& box);

/// Returns the smallest rectangle round plane_section. Across a plane of constant z, x goes to the right and y up; of constant y,
/// x and z; of constant x, y and z. The rectangle of any other plane is turned as that of the axis nearest to its normal, whichever
/// way that points.
/// Error: OutOfDomain where the plane misses the box, saying by how much; InvalidArgument where it has no direction.
Result<PlaneWindow> plane_window(const Plane& plane, const Box& box);

} // namespace wakesurf::core
