// An axis-aligned box in the dataset's length unit: domains, rakes' clipping, lattices.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

/// An axis-aligned box, given by two opposite corners.
struct Box {
    Vec3 lo{0.0}; ///< the corner of the smallest coordinates
    Vec3 hi{0.0}; ///< the corner of the largest

    /// Returns false for points with a NaN coordinate.
    bool contains(const Vec3& p) const {
        return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z &&
               p.z <= hi.z;
    }

    /// Returns the lengths of the sides.
    Vec3 extent() const { return hi - lo; }

    /// Returns the distance of the two corners.
    double diagonal() const { return glm::length(extent()); }
};

} // namespace wakesurf::core
