// A column: the vertices of a stream or path surface along one integral curve, from where the column starts
// to where the curve ends, and their spacing. A column inserted on divergence starts part-way up.
#pragma once

#include "core/integrate/curve.hpp"

#include <cstdint>
#include <numbers>
#include <vector>

namespace wakesurf::core {

/// The spacing of a column's vertices along a curve: even by arc length where the curve is straight, closer
/// together where it turns, or the sheet about it. A pure function of one curve: neighbouring columns need
/// not agree, zipping joins columns of any spacing.
struct ColumnSpacing {
    double longest; ///< arc length between vertices
    /// Limits the radians that the curve, and the sheet's normal where the curve has its stretch, may turn
    /// from one vertex to the next; pi: any.
    double turn = std::numbers::pi;

    /// A turn brings vertices no closer than this part of `longest`, so that a kink does not refine for ever.
    static constexpr double shortest = 1.0 / 8.0;
};

/// Arc lengths of the vertices from `start` to the curve's end, both included; at least one.
/// Cost: O(steps + vertices).
std::vector<double> vertex_arcs(const Curve& curve, double start, const ColumnSpacing& spacing);

/// A column: one entry a vertex, at least one; consecutive ones are at most the spacing apart.
struct Column {
    double s = 0.0;     ///< seed parameter
    double start = 0.0; ///< arc length on the curve of the first vertex
    std::vector<Vec3> position;
    std::vector<double> arc;
    std::vector<double> time; ///< since release; negative upstream
    std::vector<Vec3> stretch;

    std::size_t segments() const { return position.size() - 1; }
};

/// @param start  arc length of the first vertex, 0..curve.last.arc
Column make_column(double s, const Curve& curve, double start, const ColumnSpacing& spacing);

/// Returns the arc length on `curve` nearest to `target`, searched from `guess` within `reach` either way.
double nearest_arc(const Curve& curve, const Vec3& target, double guess, double reach);

} // namespace wakesurf::core
