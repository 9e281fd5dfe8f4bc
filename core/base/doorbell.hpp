// What idle threads sleep at, without a lock: no thread that rings waits for another. To notify a condition variable of glibc 2.36 is to
// wait for threads it woke before to have left, and those of low priority may be set aside on the way out: 20 to 160 ms on a busy machine.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace wakesurf::core {

/// A thread notes rings(), looks for work, and sleeps until the next ring where there is none: no ring is missed.
/// Thread safety: everything may be called from any thread. Cost of a ring while no one sleeps: two atomic
/// operations. Linux: futex(2).
class Doorbell {
  public:
    using Count = std::uint32_t;

    /// Wraps around: only whether it has changed tells anything.
    Count rings() const { return rings_; }

    /// For any one of those who sleep.
    void ring_one() { ring(1); }

    void ring_all();

    /// Returns at once when it has rung since it had rung `seen` times.
    void wait(Count seen);

    /// @param most  returns after that as well
    void wait(Count seen, std::chrono::nanoseconds most);

    /// The same with the lock open meanwhile, as a condition variable does.
    void wait(std::unique_lock<std::mutex>& lock, Count seen) {
        lock.unlock();
        wait(seen);
        lock.lock();
    }

    void wait(std::unique_lock<std::mutex>& lock, Count seen, std::chrono::nanoseconds most) {
        lock.unlock();
        wait(seen, most);
        lock.lock();
    }

  private:
    void ring(int sleepers);

    std::atomic<Count> rings_{0};
    std::atomic<Count> sleepers_{0};
};

} // namespace wakesurf::core
