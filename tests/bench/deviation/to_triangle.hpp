// Distance from a point to a triangle: Ericson, Real-Time Collision Detection, 2005, 5.1.5.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::bench {

inline double
to_triangle(const core::Vec3& p, const core::Vec3& a, const core::Vec3& b, const core::Vec3& c) {
    using glm::dot;
    const core::Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp);
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0)
        return glm::length(ap);
    if (d3 >= 0 && d4 <= d3)
        return glm::length(bp);
    if (d6 >= 0 && d5 <= d6)
        return glm::length(cp);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return glm::length(ap - d1 / (d1 - d3) * ab);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return glm::length(ap - d2 / (d2 - d6) * ac);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6)
        return glm::length(bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
    return glm::length(ap - (vb * ab + vc * ac) / (va + vb + vc));
}

} // namespace wakesurf::bench
