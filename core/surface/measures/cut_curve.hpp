// Where a surface meets a plane or a box, and how old it is there.
#pragma once

#include "core/surface/measures/surface_parts.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

/// A weighted value: an age on a piece of a curve, or on a part of a surface.
struct WeightedValue {
    double value;
    double weight;
};

/// Returns the value that this share of the weight is not above; not_known where there is no weight. Sorts them.
double weighted_quantile(std::vector<WeightedValue>& values, double share);

/// The curve in which a surface meets a plane or the sides of a box.
struct CutCurve {
    double length = 0.0;
    /// Of the ages where particles come to the plane or into the box, by the length of the curve.
    double least, median, p90;
    /// The ages on 99 % of the curve are off by no more, for each of the errors; not_known where less than half of the
    /// curve has one.
    std::vector<double> error99;
};

/// @param bounds  what limits the surface: the first `others` for other reasons, those that follow cut the curve, which
///                is where one of them is 0 and none is negative
/// @param errors  lists of one length a vertex, not_known where it has none. An error counts as if it were the distance
///                by which the surface is off where it meets the plane: the age is off by how much it changes that far along.
CutCurve cut_curve(const QuadComplex& mesh,
                   std::span<const VertexFunction> bounds,
                   std::size_t others,
                   std::span<const double> ages,
                   std::span<const std::span<const double>> errors);

} // namespace wakesurf::core
