// A series made on demand. A closed gate blocks every load; the order of loads and the most time-steps alive
// at once are recorded.
#pragma once

#include "core/dataset/time_step_source.hpp"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace wakesurf::tests {

inline constexpr std::size_t step_bytes = 4096;

class GatedSource final : public core::TimeStepSource {
  public:
    explicit GatedSource(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            times_.push_back(static_cast<double>(i));
    }

    const core::Grid& grid() const override { return grid_; }

    const core::SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    bool ready(std::size_t index) const override { return index < ready_steps; }

    std::size_t bytes_per_step() const override { return step_bytes; }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token stop) const override {
        Alive alive(*this);
        {
            std::unique_lock lock(mutex_);
            order_.push_back(index);
            changed_.notify_all();
            changed_.wait(lock, stop, [&] { return open_; });
        }
        if (stop.stop_requested())
            return core::fail(core::Error::Code::Cancelled, "stopped");
        if (failing)
            return core::fail(core::Error::Code::Io, "the disk is on fire");
        alive.handed_over = true;
        return std::shared_ptr<const core::TimeStep>(
            new core::TimeStep{index, times_[index], core::Slab(64)},
            [this](const core::TimeStep* step) {
                delete step;
                --alive_;
            });
    }

    void close() {
        const std::scoped_lock lock(mutex_);
        open_ = false;
    }

    void open() {
        const std::scoped_lock lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

    void wait_for_loads(std::size_t count) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return order_.size() >= count; });
    }

    std::vector<std::size_t> order() const {
        const std::scoped_lock lock(mutex_);
        return order_;
    }

    std::size_t alive() const { return alive_; }

    std::size_t most_alive() const { return most_; }

    std::atomic<bool> failing{false};
    std::atomic<std::size_t> ready_steps{1'000'000};

  private:
    // Counts a load in flight as alive as well; its result takes the count over.
    struct Alive {
        explicit Alive(const GatedSource& source) : source_(source) {
            const std::size_t now = ++source_.alive_;
            std::size_t most = source_.most_;
            while (now > most && !source_.most_.compare_exchange_weak(most, now)) {
            }
        }

        ~Alive() { source_.alive_ -= handed_over ? 0 : 1; }

        bool handed_over = false;

        const GatedSource& source_;
    };

    core::Grid grid_;
    core::SolidMask mask_;
    std::vector<double> times_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    bool open_ = true;
    mutable std::vector<std::size_t> order_;
    mutable std::atomic<std::size_t> alive_{0};
    mutable std::atomic<std::size_t> most_{0};
};

} // namespace wakesurf::tests
