// Holes of a moving surface that no body has made: what was torn amid living particles is closed again, with
// triangles between the vertices of its border.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <cstddef>

namespace wakesurf::core {

/// Closes every hole that triangles can close whose edges are within the separation, that face the right way
/// in (s, t), and that do not pass through a body. Returns how many triangles were made.
/// Cost: O(triangles), and the cube of a hole's edges.
std::size_t close_holes(const RefinementContext& context);

} // namespace wakesurf::core
