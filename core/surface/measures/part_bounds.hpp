// The functions that limit a surface, not negative on what counts: what is younger than an age, inside a box, or on one side of a plane.
#pragma once

#include "core/surface/measures/region.hpp"
#include "core/surface/measures/surface_parts.hpp"
#include "core/surface/quad_complex.hpp"

#include <vector>

namespace wakesurf::core {

/// @param ages  one a vertex
std::vector<VertexFunction> age_bound(const std::vector<double>& ages, double age);

/// Adds one function of a plane, or six of a box.
void add_bounds(std::vector<VertexFunction>& bounds, const QuadComplex& mesh, const Region& region);

} // namespace wakesurf::core
