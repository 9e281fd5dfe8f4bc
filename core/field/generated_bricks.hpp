// A built-in flow as the bricks of a grid that no disk needs to hold: what reads them is real, only the data
// are made when they are asked for. For tests and benchmarks of what pages bricks. Beside
// store/stored_bricks.hpp on the path.
#pragma once

#include "core/base/worker_threads.hpp"
#include "core/dataset/brick_source.hpp"
#include "core/dataset/time_step_source.hpp"
#include "core/field/flow.hpp"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// Computes the values that `wakesurf generate` writes for the same flow, grid and times. It takes next to no
/// memory; where the flow has an obstacle, a byte a node of the bricks that its walls go through. Thread
/// safety: concurrent calls are fine.
class GeneratedBricks final : public TimeStepSource, public BrickSource {
  public:
    /// @param flow   NAME[?k=v,...] of make_analytic_flow
    /// @param times  strictly increasing, at least one
    /// @param cells  an axis of a brick, a power of two Error: as make_analytic_flow; InvalidArgument for a
    ///               grid thinner than 2 nodes and times that do not rise.
    static Result<std::shared_ptr<const GeneratedBricks>>
    make(std::string_view flow,
         const UniformGrid& grid,
         std::vector<double> times,
         std::uint32_t cells = BrickLayout::usual_cells,
         std::size_t threads = 4);

    const Grid& grid() const override { return grid_; }

    const SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    bool ready(std::size_t index) const override { return index < times_.size(); }

    std::size_t bytes_per_step() const override;

    /// Fails always with Unsupported, because there are only bricks.
    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token stop) const override;

    const BrickSource* bricks() const override { return this; }

    const BrickLayout& layout() const override { return layout_; }

    bool gaps(std::size_t) const override { return false; }

    void read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const override;

  private:
    GeneratedBricks(std::unique_ptr<Flow> flow,
                    const UniformGrid& grid,
                    std::vector<double> times,
                    std::uint32_t cells,
                    std::size_t threads);

    /// Returns the position of a brick's node; nodes beyond the grid are where its last ones are.
    Vec3 position(std::size_t brick, std::size_t node) const;

    Result<void> sample(const BrickRead& read, const std::stop_token& stop) const;

    std::unique_ptr<Flow> flow_;
    Grid grid_;
    std::vector<double> times_;
    BrickLayout layout_;
    SolidMask mask_;
    mutable WorkerThreads threads_; ///< last: they use what is above
};

} // namespace wakesurf::core
