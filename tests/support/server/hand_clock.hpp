// Time under the control of a test: a clock, and a loop whose timers use it.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/loop.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace wakesurf::server {

class HandClock final : public core::Clock {
  public:
    std::chrono::steady_clock::time_point now() const override { return time; }

    std::chrono::steady_clock::time_point time{};
};

/// Runs tasks and timers. REQUIRES: everything on one thread.
class HandLoop final : public Loop {
  public:
    explicit HandLoop(HandClock& clock) : clock_(clock) {}

    void post(std::function<void()> task) override { posted_.push_back(std::move(task)); }

    std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                std::function<void()> task) override {
        auto ticket = std::make_shared<std::function<void()>>(std::move(task));
        timers_.emplace(clock_.time + delay, ticket);
        return ticket;
    }

    /// Runs what has been posted and what becomes due, each at its time.
    void advance(std::chrono::milliseconds by) {
        const auto end = clock_.time + by;
        run_posted();
        while (!timers_.empty() && timers_.begin()->first <= end) {
            const auto due = timers_.extract(timers_.begin());
            clock_.time = std::max(clock_.time, due.key());
            if (const auto task = due.mapped().lock())
                (*task)();
            run_posted();
        }
        clock_.time = end;
    }

  private:
    void run_posted() {
        while (!posted_.empty()) {
            const auto task = std::move(posted_.front());
            posted_.pop_front();
            task();
        }
    }

    HandClock& clock_;
    std::deque<std::function<void()>> posted_;
    std::multimap<std::chrono::steady_clock::time_point, std::weak_ptr<std::function<void()>>>
        timers_;
};

} // namespace wakesurf::server
