// The limit of one core of this machine: RK4 on two time-steps in float, hand-written for AVX2, without
// domain checks, obstacles or tangents. The yardstick of the engine's own kernel (docs/measurements.md,
// Advection); it is not shipped.
#pragma once

#include "core/dataset/grid.hpp"

#include <span>

namespace wakesurf::bench {

/// A place in cells from the grid's origin; w unused.
struct alignas(16) CellPosition {
    float x, y, z, w;
};

struct LimitField {
    const float* first;  ///< float3 a node, x fastest, 64 readable bytes after the last
    const float* second; ///< the time-step after it
    core::UniformGrid grid;
};

/// Says whether this CPU has AVX2 and FMA.
bool limit_kernel_runs_here();

/// Carries all from the first time-step to the second, `steps` RK4 steps in `interval` time units. Outside
/// the grid the field is continued constantly.
void advance_at_the_limit(const LimitField& field,
                          std::span<CellPosition> particles,
                          double interval,
                          int steps);

} // namespace wakesurf::bench
