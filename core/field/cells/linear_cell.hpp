// Where a particle goes in a field that is linear in space and does not change: the closed form by the
// exponential of its matrix. In a tetrahedron the stored velocity is such a field. Source: Scheuermann,
// Bobach, Hagen, Mahrous, Hamann, Joy, Kollmann, A Tetrahedra-Based Stream Surface Algorithm, 2001.
#pragma once

#include "core/base/vec3.hpp"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

/// Returns how far a particle of velocity `v` has gone after a time t >= 0, where velocity changes by `slope`
/// times the way: the integral of exp(slope t) v, to rounding. It sums the exponential's series in pieces of
/// the time within which it has no cancellation.
inline Vec3 linear_way(const glm::dmat3& slope, const Vec3& v, double t) {
    double norm = 0.0;
    for (int column = 0; column < 3; ++column) {
        const Vec3 entries = glm::abs(slope[column]);
        norm = std::max(norm, entries.x + entries.y + entries.z);
    }
    const double pieces =
        std::clamp(std::ceil(norm * t), 1.0, 1e4); // 1e4: of e^10000 nothing is left in a cell
    const double h = t / pieces;
    Vec3 way(0.0);
    for (double piece = 0.0; piece < pieces; ++piece) {
        Vec3 term = (v + slope * way) * h;
        Vec3 sum = term;
        for (double k = 2.0; k < 30.0 && glm::dot(term, term) > 1e-34 * glm::dot(sum, sum); ++k) {
            term = slope * term * (h / k);
            sum += term;
        }
        way += sum;
    }
    return way;
}

} // namespace wakesurf::core
