// The loop of a session, turned by hand: the test runs tasks and advances time.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/loop.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace wakesurf::tests {

class HandLoop final : public server::Loop, public core::Clock {
  public:
    void post(std::function<void()> task) override {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
        posted_.notify_one();
    }

    std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                std::function<void()> task) override {
        auto ticket = std::make_shared<std::function<void()>>(std::move(task));
        timers_.push_back({now_ + delay, ticket});
        return ticket;
    }

    std::chrono::steady_clock::time_point now() const override { return now_; }

    /// Runs tasks, waiting for them to be posted, until `done`.
    void turn_until(const std::function<bool()>& done) {
        while (!done()) {
            std::unique_lock lock(mutex_);
            posted_.wait(lock, [this] { return !tasks_.empty(); });
            const auto task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
        }
    }

    /// Lets time pass; what falls due happens in order.
    void pass(std::chrono::milliseconds time) {
        const auto until = now_ + time;
        const auto sooner = [](const Timer& a, const Timer& b) { return a.due < b.due; };
        while (!timers_.empty()) {
            const auto next = std::min_element(timers_.begin(), timers_.end(), sooner);
            if (next->due > until)
                break;
            now_ = std::max(now_, next->due);
            const auto task = next->task.lock();
            timers_.erase(next);
            if (task)
                (*task)();
        }
        now_ = until;
    }

  private:
    struct Timer {
        std::chrono::steady_clock::time_point due;
        std::weak_ptr<std::function<void()>> task;
    };

    std::mutex mutex_;
    std::condition_variable posted_;
    std::deque<std::function<void()>> tasks_;
    std::vector<Timer> timers_;
    std::chrono::steady_clock::time_point now_{};
};

} // namespace wakesurf::tests
