// A session's loop turned by the test's own thread, waiting for what other threads post to it.
#pragma once

#include "server/base/loop.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace wakesurf::tests {

/// Runs tasks. Timers never fire.
class WaitingLoop final : public server::Loop {
  public:
    void post(std::function<void()> task) override {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
        posted_.notify_one();
    }

    std::shared_ptr<void> after(std::chrono::milliseconds, std::function<void()>) override {
        return nullptr;
    }

    /// Runs tasks, waiting for them to be posted, until `done`; gives up after half a minute.
    void turn_until(const std::function<bool()>& done) {
        while (!done()) {
            std::unique_lock lock(mutex_);
            if (!posted_.wait_for(lock, std::chrono::seconds(30),
                                  [this] { return !tasks_.empty(); }))
                return ADD_FAILURE() << "nothing was posted", void();
            const auto task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
        }
    }

  private:
    std::mutex mutex_;
    std::condition_variable posted_;
    std::deque<std::function<void()>> tasks_;
};

} // namespace wakesurf::tests
