// A time-step in memory, and where the cache gets it from: the store reader, or a test's own series.
#pragma once

#include "core/base/periodic_axes.hpp"
#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/grid.hpp"
#include "core/dataset/slab.hpp"
#include "core/dataset/solid_mask.hpp"
#include "core/dataset/step_nodes.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

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

class BrickSource;

/// Reads time-steps. Thread safety: concurrent calls are allowed.
class TimeStepSource {
  public:
    virtual ~TimeStepSource() = default;

    /// Returns the grid that all time-steps share; it lives as long as the source.
    virtual const Grid& grid() const = 0;

    /// Empty for cell meshes, whose walls are faces.
    virtual const SolidMask& mask() const = 0;

    /// Says along which axes the flow repeats; the grid's box is one period then.
    virtual PeriodicAxes periodic() const { return {}; }

    /// Returns the times of all time-steps of the series, strictly increasing, whether written yet or not.
    virtual const std::vector<double>& times() const = 0;

    /// True when load(index) can succeed now: while an import runs, steps become ready one by one.
    virtual bool ready(std::size_t index) const = 0;

    /// Memory load(index) takes.
    virtual std::size_t bytes_per_step() const = 0;

    /// Loads a time-step. Error: NotFound (not written yet), Corrupt, Io, Cancelled.
    virtual Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                         std::stop_token stop) const = 0;

    /// Returns the time-steps brick by brick, if they exist so, else null; lives as long as the source.
    virtual const BrickSource* bricks() const { return nullptr; }

    /// Returns the memory that it keeps for the next load to the system.
    virtual void release_memory() const {}
};

} // namespace wakesurf::core
