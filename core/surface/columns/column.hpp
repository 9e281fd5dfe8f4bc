// A column: the vertices of a stream or path surface along one integral curve, from where the column starts
// to where the curve ends. A column inserted on divergence starts part-way up.
#pragma once

#include "core/integrate/curve.hpp"
#include "core/surface/columns/column_spacing.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

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
