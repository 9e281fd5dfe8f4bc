// Turning edges of a moving surface: the shorter diagonal of two neighbouring triangles is the better edge,
// and shear changes which that is.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <vector>

namespace wakesurf::core {

/// True where turning an edge leaves fewer webs (see is_web()), or makes the worse of the two triangles
/// better and no edge that would be cut; and turns nothing over in (s, t).
bool should_flip(const RefinementContext& context, TriangleId t, unsigned k);

/// Turns edges of the triangles in `queue`, and of those that it changes, until none is worth it, or each has
/// been turned twenty times on average. The queue is empty then.
void flip_all(const RefinementContext& context, std::vector<TriangleId>& queue);

} // namespace wakesurf::core
