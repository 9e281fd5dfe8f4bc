// The range of the values at the vertices of a surface, for colours: without the last per cent of its area,
// which beside walls and at singular places has values many times as large as all others.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

struct ValueRange {
    double low = 0.0, high = 0.0;       ///< of all but the last per cent of the area
    double least = 0.0, greatest = 0.0; ///< of all

    bool operator==(const ValueRange&) const = default;
};

/// A quarter of the area of each cell round a vertex that has it as a corner.
std::vector<float> vertex_areas(const QuadComplex& complex);

/// Leaves out the last per cent at the upper end, and at the lower end if there are values below zero: each
/// only if it would take more than a fifth of the range. Of many vertices a sample is taken, the same each
/// time; `least` and `greatest` are of all. Empty if no value is finite.
/// @param areas  one a value; without any, or if they are all 0, each vertex counts the same
std::optional<ValueRange> value_range(std::span<const double> values, std::span<const float> areas);

/// Returns the range of both.
ValueRange joined(const ValueRange& a, const ValueRange& b);

} // namespace wakesurf::core
