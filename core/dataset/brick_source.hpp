// Where bricks of time-steps come from: a store's files, other processes, a web server, or a flow that is
// sampled brick by brick. Beside core/dataset/time_step_source.hpp on the path; above it is
// core/dataset/brick_cache.hpp.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/brick_layout.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// A brick to read.
struct BrickRead {
    std::size_t step;  ///< index of the time-step
    std::size_t brick; ///< number in the layout
    /// Receives velocities, xyz interleaved, or a scalar's values, for a brick's nodes, x fastest.
    std::span<float> to;
    std::size_t field = 0; ///< 0: velocity; a scalar: 1 + its index
};

/// Reads bricks. Thread safety: concurrent calls are allowed.
class BrickSource {
  public:
    /// Called once for each read that was asked for, with its index among them, from any thread, in any
    /// order, also before read() returns. Error: Corrupt, Io, NotFound (not written yet), Cancelled; it names
    /// the brick. What the brick holds then is anything.
    using Done = std::function<void(std::size_t index, Result<void> outcome)>;

    virtual ~BrickSource() = default;

    /// Returns the layout that all time-steps share.
    virtual const BrickLayout& layout() const = 0;

    /// Some velocities of the time-step may not be finite. REQUIRES: the time-step is ready.
    virtual bool gaps(std::size_t step) const = 0;

    /// Starts to read, in the order that serves the source best, and returns at once. Where `stop` fires,
    /// reads that have not begun end as Cancelled. The destructor waits for all that is under way.
    virtual void read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const = 0;
};

} // namespace wakesurf::core
