// A moving surface that can be evaluated at any time, again and again: plays on, pauses, steps back to stored
// checkpoints. Its mesh at a time does not depend on earlier evaluations.
#pragma once

#include "core/surface/moving/moving_surface.hpp"

#include <cstddef>
#include <map>
#include <stop_token>

namespace wakesurf::core {

/// Evaluates a moving surface. Thread safety: one thread at a time.
class SurfaceHistory {
  public:
    /// @param surface       as MovingSurface::start returns it
    /// @param budget_bytes  for checkpoints; when it is full, every other one is given up. The first always
    ///                      stays.
    SurfaceHistory(MovingSurface surface, std::size_t budget_bytes);

    /// Returns the mesh at a time between the surface's first and its end. Steps from the newest checkpoint
    /// before it, or from the present state, reporting to `work` the progress and the memory, checkpoints
    /// apart. Error: OutOfTime; Cancelled, and OverLimit without memory, after which the next call continues
    /// from a checkpoint; as stepping.
    Result<KeyedMesh> at(double time, std::stop_token stop, const WorkPart& work = {});

    /// Returns the bytes of the checkpoints.
    std::size_t bytes() const { return bytes_; }

    /// Another budget for checkpoints; gives up at once what is over it.
    void limit(std::size_t budget_bytes);

    /// Returns the statistics of what at() gave last; seconds are of the steps that are kept.
    const SurfaceStatistics& statistics() const { return statistics_; }

    /// Returns the state that the steps have reached, at or before the last result of at().
    const MovingSurface& surface() const { return surface_; }

  private:
    double since_start(double time) const { return direction_ * (time - start_); }

    void keep();
    void thin();
    Result<void> go_to(double time, const std::stop_token& stop, const WorkPart& work);

    MovingSurface surface_;
    SurfaceStatistics statistics_;
    bool torn_ = false; ///< it ended within a step: a checkpoint replaces it first
    double start_;
    double direction_;
    std::size_t budget_;
    std::size_t bytes_ = 0;
    std::uint64_t every_ = 1;                   ///< steps between checkpoints
    std::map<double, MovingState> checkpoints_; ///< by time since the start
};

} // namespace wakesurf::core
