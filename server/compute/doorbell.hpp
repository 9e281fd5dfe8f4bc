// What idle threads sleep at. Its lock is held for an instant, and by none that works: who rings never waits for a job.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace wakesurf::server {

/// A thread notes rings(), looks for work, and sleeps until the next ring where there is none: no ring is missed.
/// Thread safety: everything may be called from any thread.
class Doorbell {
  public:
    std::uint64_t rings() const { return rings_.load(std::memory_order_acquire); }

    /// For any one of those who sleep.
    void ring_one() {
        count();
        bell_.notify_one();
    }

    void ring_all() {
        count();
        bell_.notify_all();
    }

    /// Returns at once when it has rung since it had rung `seen` times.
    void wait(std::uint64_t seen) {
        std::unique_lock lock(mutex_);
        bell_.wait(lock, [&] { return rings_ != seen; });
    }

    /// @param most  returns after that as well
    void wait(std::uint64_t seen, std::chrono::milliseconds most) {
        std::unique_lock lock(mutex_);
        bell_.wait_for(lock, most, [&] { return rings_ != seen; });
    }

  private:
    void count() {
        const std::lock_guard lock(mutex_);
        ++rings_;
    }

    std::atomic<std::uint64_t> rings_{0};
    std::mutex mutex_;
    std::condition_variable bell_;
};

} // namespace wakesurf::server
