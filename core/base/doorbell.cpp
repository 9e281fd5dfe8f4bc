#include "core/base/doorbell.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>
#include <limits>

namespace wakesurf::core {

namespace {

static_assert(sizeof(std::atomic<Doorbell::Count>) == sizeof(Doorbell::Count),
              "as the kernel sees it");

/// @param most  null: without end
void sleep_while(const std::atomic<Doorbell::Count>& rings,
                 Doorbell::Count seen,
                 const timespec* most) {
    syscall(SYS_futex, &rings, FUTEX_WAIT_PRIVATE, seen, most, nullptr, 0);
}

} // namespace

// Who rings counts first and then looks for sleepers, who sleeps is counted first and then, by the kernel, looks at the count: in the one
// order of all of these, one of them sees the other.
void Doorbell::ring(int sleepers) {
    ++rings_;
    if (sleepers_ > 0)
        syscall(SYS_futex, &rings_, FUTEX_WAKE_PRIVATE, sleepers, nullptr, nullptr, 0);
}

void Doorbell::ring_all() {
    ring(std::numeric_limits<int>::max());
}

void Doorbell::wait(Count seen) {
    ++sleepers_;
    while (rings_ == seen) // signals wake, too
        sleep_while(rings_, seen, nullptr);
    --sleepers_;
}

void Doorbell::wait(Count seen, std::chrono::nanoseconds most) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::nanoseconds second = std::chrono::seconds(1);
    const auto end = Clock::now() + most;
    ++sleepers_;
    for (auto left = most; rings_ == seen && left.count() > 0; left = end - Clock::now()) {
        const timespec time{static_cast<std::time_t>(left / second),
                            static_cast<long>((left % second).count())};
        sleep_while(rings_, seen, &time);
    }
    --sleepers_;
}

} // namespace wakesurf::core
