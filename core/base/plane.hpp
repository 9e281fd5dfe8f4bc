// A plane in space: where surfaces are cut, and where fields are sliced.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

/// A plane without end.
struct Plane {
    Vec3 point;  ///< on it
    Vec3 normal; ///< of any length above 0; flux towards it is positive

    /// Returns how far a place is on the side of the normal, in units of length.
    double height(const Vec3& p) const { return glm::dot(p - point, normal) / glm::length(normal); }
};

} // namespace wakesurf::core
