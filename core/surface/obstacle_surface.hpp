// The wall of an obstacle as a mesh for display: the faces midway between fluid and solid nodes, where the
// flow stops particles (SolidMask).
#pragma once

#include "core/dataset/grid.hpp"
#include "core/dataset/solid_mask.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/surface/quad_complex.hpp"

namespace wakesurf::core {

/// A quad for every pair of neighbouring nodes of which one is solid, seen counter-clockwise from the fluid;
/// what lies beyond the domain counts as fluid, so an obstacle that meets the border is capped there.
/// Vertices are shared between the quads: the wall is closed. Only positions and cells are filled in. Cost:
/// O(nodes). The same quads in the same order for a mask in one piece and in bricks. REQUIRES: a mask of the
/// grid's nodes, or none.
QuadComplex obstacle_surface(const UniformGrid& grid, const SolidMask& mask);
QuadComplex obstacle_surface(const RectilinearGrid& grid, const SolidMask& mask);

/// Returns the walls of either kind of grid; nothing for a mesh of cells, whose walls are faces and have no
/// mask.
QuadComplex obstacle_surface(const Grid& grid, const SolidMask& mask);

/// Walls as cells, each a triangle whose third corner comes twice. Only positions and cells are filled in.
QuadComplex wall_surface(const WallGeometry& walls);

} // namespace wakesurf::core
