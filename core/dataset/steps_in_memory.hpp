// A series that is in memory already: arrays of one's own as time-steps.
#pragma once

#include "core/dataset/time_step_source.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// A source that loads nothing: all its steps are in memory. Thread safety: concurrent calls are allowed.
class StepsInMemory final : public TimeStepSource {
  public:
    /// The velocity at every node of the grid at one time: x, y and z of the first node (node_position), then
    /// of the next. At a value that is not finite the domain has a gap at that time.
    using Velocity = std::span<const float>;

    /// Copies the velocities.
    /// @param times     strictly increasing
    /// @param velocity  one a time
    /// @param mask      of uniform and rectilinear grids; empty: no obstacle
    /// Error: InvalidArgument where sizes do not match, or times do not rise.
    static Result<std::shared_ptr<const StepsInMemory>> make(Grid grid,
                                                             std::vector<double> times,
                                                             const std::vector<Velocity>& velocity,
                                                             SolidMask mask = {});

    /// Returns the grid as it was given.
    const Grid& grid() const override { return grid_; }

    const SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return bytes_; }

    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token stop) const override;

  private:
    StepsInMemory(Grid grid, std::vector<double> times, SolidMask mask);

    Grid grid_;
    SolidMask mask_;
    std::vector<double> times_;
    std::size_t bytes_;
    std::vector<std::shared_ptr<const TimeStep>> steps_;
};

} // namespace wakesurf::core
