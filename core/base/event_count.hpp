// An event count: idle threads sleep at it without a lock, so that no thread that notifies waits for another.
// Notifying a condition variable of glibc 2.36 waits for threads that it woke before to have left; those of
// low priority may be preempted on the way out, which takes 20 to 160 ms on a busy machine.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace wakesurf::core {

/// Lets a thread note notifications(), look for work, and sleep until the next notification where there is
/// none: no notification is missed. Thread safety: everything may be called from any thread. Cost of a
/// notification while no one sleeps: two atomic operations. Linux: futex(2).
class EventCount {
  public:
    using Count = std::uint32_t;

    /// Returns a count that wraps around: only whether it has changed tells anything.
    Count notifications() const { return notifications_; }

    /// Wakes any one of the sleeping threads.
    void notify_one() { notify(1); }

    void notify_all();

    /// Sleeps until the count of notifications is no longer `seen`.
    void wait(Count seen);

    /// @param most  returns after that as well
    void wait(Count seen, std::chrono::nanoseconds most);

    /// Waits with the lock released meanwhile, as a condition variable does.
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
    void notify(int sleepers);

    std::atomic<Count> notifications_{0};
    std::atomic<Count> sleepers_{0};
};

} // namespace wakesurf::core
