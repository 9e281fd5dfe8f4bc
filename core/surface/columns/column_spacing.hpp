// Where along a curve a column has its vertices: evenly by arc length where the curve is straight, closer
// together where it turns, or the sheet about it. A pure function of one curve: neighbouring columns need
// not agree, zipping joins columns of any spacing.
#pragma once

#include "core/integrate/curve.hpp"

#include <numbers>
#include <vector>

namespace wakesurf::core {

struct ColumnSpacing {
    double longest; ///< arc length between vertices
    /// Limits the radians that the curve, and the sheet's normal where the curve has its stretch, may turn from
    /// one vertex to the next; pi: any.
    double turn = std::numbers::pi;

    /// A turn brings vertices no closer than this part of `longest`, so that a kink does not refine for ever.
    static constexpr double shortest = 1.0 / 8.0;
};

/// Arc lengths of the vertices from `start` to the curve's end, both included; at least one.
/// Cost: O(steps + vertices).
std::vector<double> vertex_arcs(const Curve& curve, double start, const ColumnSpacing& spacing);

} // namespace wakesurf::core
