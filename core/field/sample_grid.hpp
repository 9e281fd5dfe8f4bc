// A flow as a store holds it: velocities at the nodes of a uniform grid, a piece at a time, so that a grid
// larger than memory can be written. What `wakesurf generate` puts into its files.
#pragma once

#include "core/dataset/grid.hpp"
#include "core/field/flow.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Fills `velocities` (xyz interleaved) for the nodes from `first` on; zero at nodes inside an obstacle. Runs
/// in parallel; the values are those of Flow::sample rounded to float.
///
/// @return the smallest and the largest speed at the nodes outside obstacles; {infinity, 0} where there are
/// none Error: InvalidArgument where a velocity is not finite as a float, Cancelled, and what Flow::sample
/// reports.
Result<std::array<double, 2>> sample_nodes(const Flow& flow,
                                           const UniformGrid& grid,
                                           std::size_t first,
                                           double time,
                                           std::span<float> velocities,
                                           std::stop_token stop);

/// Samples places anywhere, in the calling thread, without stopping.
Result<std::array<double, 2>> sample_places(const Flow& flow,
                                            std::span<const Vec3> places,
                                            double time,
                                            std::span<float> velocities);

/// Samples the solid mask of the same nodes: 0 inside an obstacle, else 1.
void sample_mask(const Flow& flow,
                 const UniformGrid& grid,
                 std::size_t first,
                 std::span<std::uint8_t> fluid);

} // namespace wakesurf::core
