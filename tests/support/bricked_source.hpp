// Any series on a uniform or rectilinear grid brick by brick, in an order of arrival that a seed decides.
#pragma once

#include "core/dataset/brick_source.hpp"
#include "core/dataset/time_step_source.hpp"
#include "tests/support/mask_bytes.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>
#include <thread>
#include <utility>

namespace wakesurf::tests {

class BrickedSource final : public core::TimeStepSource, public core::BrickSource {
  public:
    BrickedSource(std::shared_ptr<const core::TimeStepSource> whole,
                  std::uint32_t cells,
                  unsigned seed = 0)
        : whole_(std::move(whole)), layout_(dimensions_of(whole_->grid()), cells),
          mask_(mask_in_bricks(whole_->mask(), layout_)), random_(seed) {
        for (std::size_t i = 0; i < whole_->times().size(); ++i)
            steps_.push_back(*whole_->load(i, {}));
    }

    ~BrickedSource() override { answer_.reset(); }

    const core::Grid& grid() const override { return whole_->grid(); }

    const core::SolidMask& mask() const override { return mask_; }

    core::PeriodicAxes periodic() const override { return whole_->periodic(); }

    const std::vector<double>& times() const override { return whole_->times(); }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return whole_->bytes_per_step(); }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token) const override {
        return steps_[index];
    }

    const core::BrickSource* bricks() const override { return this; }

    const core::BrickLayout& layout() const override { return layout_; }

    bool gaps(std::size_t step) const override { return steps_[step]->gaps; }

    /// Answers from a thread of its own, one brick after the other, or at once.
    void read(std::vector<core::BrickRead> reads, std::stop_token, Done done) const override {
        std::vector<std::size_t> order(reads.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        {
            const std::scoped_lock lock(mutex_);
            std::shuffle(order.begin(), order.end(), random_);
        }
        const std::scoped_lock lock(mutex_);
        read_ += reads.size();
        if (at_once) {
            for (const std::size_t i : order)
                done(i, fill(reads[i]));
            return;
        }
        answer_ = std::make_unique<std::jthread>(
            [this, reads = std::move(reads), order = std::move(order), done = std::move(done),
             before = std::shared_ptr<std::jthread>(std::move(answer_))] {
                for (const std::size_t i : order)
                    done(i, fill(reads[i]));
            });
    }

    std::size_t read_so_far() const { return read_; }

    bool at_once = false;                             ///< bricks are there when read() returns
    std::atomic<std::size_t> broken{~std::size_t{0}}; ///< the brick that cannot be read
    /// The first time-step from which no brick can be read.
    std::atomic<std::size_t> broken_from{~std::size_t{0}};

  private:
    static std::array<std::uint32_t, 3> dimensions_of(const core::Grid& grid) {
        if (const auto* uniform = std::get_if<core::UniformGrid>(&grid))
            return uniform->dimensions;
        const auto& axes = std::get<core::RectilinearGrid>(grid).coordinates;
        return {static_cast<std::uint32_t>(axes[0].size()),
                static_cast<std::uint32_t>(axes[1].size()),
                static_cast<std::uint32_t>(axes[2].size())};
    }

    core::Result<void> fill(const core::BrickRead& read) const {
        if (read.brick == broken || read.step >= broken_from)
            return core::fail(core::Error::Code::Corrupt,
                              "brick " + std::to_string(read.brick) + " is damaged");
        const auto first = layout_.first_node(read.brick);
        const auto& nodes = layout_.brick_nodes();
        const auto& grid = layout_.dimensions();
        float* to = read.to.data();
        for (std::size_t z = 0; z < nodes[2]; ++z)
            for (std::size_t y = 0; y < nodes[1]; ++y)
                for (std::size_t x = 0; x < nodes[0]; ++x) {
                    const std::size_t node =
                        std::min<std::size_t>(first[0] + x, grid[0] - 1) +
                        grid[0] * (std::min<std::size_t>(first[1] + y, grid[1] - 1) +
                                   grid[1] * std::min<std::size_t>(first[2] + z, grid[2] - 1));
                    to = std::copy_n(steps_[read.step]->velocity().data() + 3 * node, 3, to);
                }
        return {};
    }

    std::shared_ptr<const core::TimeStepSource> whole_;
    core::BrickLayout layout_;
    core::SolidMask mask_;
    std::vector<std::shared_ptr<const core::TimeStep>> steps_;
    mutable std::mutex mutex_;
    mutable std::mt19937 random_;
    mutable std::atomic<std::size_t> read_{0};
    mutable std::unique_ptr<std::jthread> answer_;
};

} // namespace wakesurf::tests
