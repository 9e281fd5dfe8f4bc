// The mean of a field over parts of a surface, by area.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/measures/surface_parts.hpp"

#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// A field whose mean is wanted.
struct AveragedField {
    std::string name;
    std::string unit; ///< empty: it has none, or it is not known
    /// Returns a value for each vertex, NaN where there is none. @param times  at which each vertex is there
    std::function<Result<std::vector<float>>(
        const QuadComplex& mesh, const std::vector<double>& times, const std::stop_token& stop)>
        values;
};

/// A field's integral over the parts of a mesh that are inside of all bounds.
struct FieldIntegral {
    double value = 0.0;
    double area = 0.0;    ///< where the field is known at all vertices
    double unknown = 0.0; ///< the rest of the area

    double mean() const; ///< not_known without an area
};

/// @param values  one a vertex, linear in each triangle. Cost: O(cells).
FieldIntegral integral_over(const QuadComplex& mesh,
                            std::span<const VertexFunction> bounds,
                            std::span<const float> values);

} // namespace wakesurf::core
