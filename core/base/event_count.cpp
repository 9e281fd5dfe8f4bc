#include "core/base/event_count.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>
#include <limits>

namespace wakesurf::core {

namespace {

static_assert(sizeof(std::atomic<EventCount::Count>) == sizeof(EventCount::Count),
              "as the kernel sees it");

/// @param most  null: without a time limit
void sleep_while(const std::atomic<EventCount::Count>& notifications,
                 EventCount::Count seen,
                 const timespec* most) {
    syscall(SYS_futex, &notifications, FUTEX_WAIT_PRIVATE, seen, most, nullptr, 0);
}

} // namespace

// The notifier increments `notifications_`, then reads `sleepers_`. The sleeper increments `sleepers_`, then
// the kernel compares `notifications_`. In a total order of the four, at least one sees the other: no wake-up
// is lost.
void EventCount::notify(int sleepers) {
    ++notifications_;
    if (sleepers_ > 0)
        syscall(SYS_futex, &notifications_, FUTEX_WAKE_PRIVATE, sleepers, nullptr, nullptr, 0);
}

void EventCount::notify_all() {
    notify(std::numeric_limits<int>::max());
}

void EventCount::wait(Count seen) {
    ++sleepers_;
    while (notifications_ == seen) // signals wake, too
        sleep_while(notifications_, seen, nullptr);
    --sleepers_;
}

void EventCount::wait(Count seen, std::chrono::nanoseconds most) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::nanoseconds second = std::chrono::seconds(1);
    const auto end = Clock::now() + most;
    ++sleepers_;
    for (auto left = most; notifications_ == seen && left.count() > 0; left = end - Clock::now()) {
        const timespec time{static_cast<std::time_t>(left / second),
                            static_cast<long>((left % second).count())};
        sleep_while(notifications_, seen, &time);
    }
    --sleepers_;
}

} // namespace wakesurf::core
