// An event count: idle threads sleep at it without a lock, so that no thread that notifies waits for another.
// Notifying a condition variable of glibc 2.36 waits for threads that it woke before to have left; those of
// low priority may be preempted on the way out, which takes 20 to 160 ms on a busy machine.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace wakesurf::core {

/// An event count: a thread reads notifications(), looks for work, and without any sleeps until the next
/// notification, of which none is missed. Thread-safe. Cost of a notification without a sleeper: two atomic
/// operations. Linux: futex(2).
class EventCount {
  public:
    using Count = std::uint32_t;

    /// Returns a count that wraps around: only whether it has changed is meaningful.
    Count notifications() const { return notifications_; }

    /// Wakes any one of the sleeping threads.
    void notify_one() { notify(1); }

    void notify_all();

    /// Sleeps until the count of notifications is no longer `seen`.
    void wait(Count seen);

    /// Waits for at most `most`.
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
