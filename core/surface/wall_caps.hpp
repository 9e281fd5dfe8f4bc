// Closes bodies where they meet the sides of the domain, for display: the data have walls round the fluid alone, so that a body that
// goes on beyond a side is open there.
#pragma once

#include "core/dataset/wall_geometry.hpp"
#include "core/field/flow.hpp"

namespace wakesurf::core {

/// Adds triangles, with points of their own, over each loop of the walls' border that lies in a side of the domain and has no fluid
/// behind it. Inlets and outlets of ducts stay open, and what is round another loop, or is no simple loop. Cost: O(triangles), and of a
/// loop the square of its points, of which it may have 2,000.
void close_at_sides(WallGeometry& walls, const Flow& flow);

} // namespace wakesurf::core
