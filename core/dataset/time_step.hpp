// One stored field in memory: velocity at every node of the grid at one physical time.
#pragma once

#include "core/base/vec3.hpp"
#include "core/dataset/slab.hpp"
#include "core/dataset/step_nodes.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace wakesurf::core {

/// A time-step, immutable once shared. Velocity is float3 in file order (x fastest), 12 bytes a node.
struct TimeStep {
    std::size_t index = 0; ///< in the series, from 0
    double time = 0.0;     ///< of the series, in its unit
    Slab slab;             ///< the velocities
    /// The velocities instead, if they come brick by brick.
    std::shared_ptr<const BrickTable> bricks{};
    bool gaps = false; ///< some velocities are not finite: there the domain ends at this time

    /// Returns the velocities as samplers reach them.
    StepNodes nodes() const {
        return bricks ? StepNodes(bricks.get()) : StepNodes(velocity().data());
    }

    /// Returns x, y and z of the first node, then of the next. REQUIRES: not in bricks.
    std::span<const float> velocity() const {
        return {reinterpret_cast<const float*>(slab.bytes().data()),
                slab.bytes().size() / sizeof(float)};
    }
};

/// The state of a time-step: on the disk, being read, in memory.
enum class StepState { Cold, Loading, Resident };

/// The bytes of a time-step's velocity in memory, and those being read: all or none, or, brick by brick, a
/// part.
struct StepHeld {
    std::size_t resident = 0; ///< in memory
    std::size_t loading = 0;  ///< on their way

    /// Resident where anything is.
    StepState state() const {
        return resident > 0  ? StepState::Resident
               : loading > 0 ? StepState::Loading
                             : StepState::Cold;
    }

    bool operator==(const StepHeld&) const = default;
};

} // namespace wakesurf::core
