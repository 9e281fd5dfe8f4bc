// Where the cache gets its time-steps from: the store reader, or a test's own series.
#pragma once

#include "core/base/periodic_axes.hpp"
#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "core/dataset/solid_mask.hpp"
#include "core/dataset/time_step.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

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
    virtual void let_go() const {}
};

} // namespace wakesurf::core
