// The wall of an obstacle as a mesh for display: the faces midway between fluid and solid nodes, where the
// flow stops particles (SolidMask). It is drawn with the velocity near by: fluid at a wall has none.
// Laramee et al. 2004 show it so on the boundaries of meshes.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "core/dataset/solid_mask.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/field/flow.hpp"
#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

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

/// Distances from the wall, in finest spacings: the first of these that is in the fluid counts. The later
/// ones are for walls that lie a little beside the cells that they bound, like flat triangles on a round
/// body.
inline constexpr std::array<double, 3> wall_distances{0.25, 0.5, 1.0};

/// The same beside walls between solid and fluid nodes: a whole spacing off, values come from nodes in the fluid,
/// but for some hundredths in corners that face in.
inline constexpr std::array<double, 3> mask_distances{1.0, 0.5, 0.25};

/// Returns for each vertex of a wall the place in the fluid off it along the normal, whichever way the cells are
/// turned; not a number without fluid near by. Error: Cancelled.
Result<std::vector<Vec3>> places_off_wall(const QuadComplex& wall,
                                          const Flow& flow,
                                          std::span<const double> distances,
                                          const std::stop_token& stop);

/// Memory that add_wall_velocity takes beside the wall, a vertex.
inline constexpr std::size_t wall_velocity_bytes = 120;

/// Fills in the velocity of a wall's vertices at `time`: that at places_off_wall; zero without fluid near by,
/// and without a value in the data. s and t are 0. Cost: a sample and a few lookups of a place a vertex.
/// Error: as Flow::sample.
Result<void>
add_wall_velocity(QuadComplex& wall, const Flow& flow, double time, std::stop_token stop);

} // namespace wakesurf::core
