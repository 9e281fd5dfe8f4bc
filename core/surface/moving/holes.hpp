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

/// Tears bridges of up to 4 triangles between a hole beside a body and a border of a streak surface, except on the rake. Such
/// surfaces are torn from their oldest row on: the hole is a tear that has begun behind the border. Returns how many triangles
/// it took. REQUIRES: holes that can be closed are.
std::size_t open_holes(const RefinementContext& context);

} // namespace wakesurf::core
