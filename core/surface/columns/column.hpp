// A column: the vertices of a stream or path surface along one integral curve, evenly spaced by arc length from
// where the column starts to where the curve ends. A column inserted on divergence starts part-way up.
#pragma once

#include "core/integrate/curve.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

struct Column {
    double s = 0.0;                 ///< seed parameter
    std::vector<CurvePoint> points; ///< at least one; consecutive ones at most `spacing` apart

    std::size_t segments() const { return points.size() - 1; }
};

/// @param start    arc length of the first vertex, 0..curve.last.arc
/// @param spacing  longest arc length between vertices
Column make_column(double s, const Curve& curve, double start, double spacing);

/// Arc length on `curve` nearest to `target`, searched from `guess` within `reach` either way.
double nearest_arc(const Curve& curve, const Vec3& target, double guess, double reach);

} // namespace wakesurf::core
