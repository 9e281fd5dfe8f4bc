// The flow along a wall, for display: fluid at a wall has no velocity, so it is taken at a small distance.
// Laramee et al. 2004 show it so on the boundaries of meshes.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <stop_token>

namespace wakesurf::core {

/// Distances from the wall, in finest spacings: the first of these that is in the fluid counts. The later
/// ones are for walls that lie a little beside the cells that they bound, like flat triangles on a round
/// body.
inline constexpr std::array<double, 3> wall_distances{0.25, 0.5, 1.0};

/// Memory that add_wall_velocity takes beside the wall, a vertex.
inline constexpr std::size_t wall_velocity_bytes = 120;

/// Fills in the velocity of a wall's vertices at `time`: that of the fluid off the wall along the normal,
/// whichever way the cells are turned; zero without fluid near by, and without a value in the data. s and t
/// are 0. Cost: a sample and a few lookups of a place a vertex. Error: as Flow::sample.
Result<void>
add_wall_velocity(QuadComplex& wall, const Flow& flow, double time, std::stop_token stop);

} // namespace wakesurf::core
