// The flows of the benchmarks, sampled on 128^3 float32 in memory: unsteady ABC flow and a drifting tornado.
// Both repeat after `period` time-steps, so that a long series costs the memory of a short one.
#pragma once

#include "core/dataset/time_step_cache.hpp"
#include "core/field/flow.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::bench {

struct SampledFlow {
    static constexpr std::uint32_t nodes_per_side = 128;
    static constexpr std::size_t period = 8;

    core::UniformGrid grid;
    /// Time between two time-steps: particles move about 3 cells in it, 18 in the slow one.
    double interval = 0.0;
    std::vector<std::shared_ptr<const core::TimeStep>> steps; ///< 0..period
    std::unique_ptr<core::Flow> flow;                         ///< over all of them

    double spacing() const { return grid.spacing.x; }

    /// Returns a time-step of the endless series.
    const core::TimeStep& step(std::size_t index) const { return *steps[index % period]; }
};

/// Returns a cube of side 2 pi. Sampled at the first call (a second or two), then kept.
const SampledFlow& sampled_abc();

/// Returns it on a rectilinear grid, whose axes are even so that only the way to the cells differs.
const SampledFlow& sampled_abc_on_axes();

/// Returns it six times slower: long enough for a streak surface to cross the cube.
const SampledFlow& sampled_slow_abc();

/// Returns the unit cube, likewise.
const SampledFlow& sampled_tornado();

} // namespace wakesurf::bench
