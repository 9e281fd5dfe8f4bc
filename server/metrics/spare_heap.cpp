#include "server/metrics/spare_heap.hpp"

#include <malloc.h>

#include <atomic>
#include <ctime>

namespace wakesurf::server {

namespace {

constexpr std::chrono::milliseconds between{250};

} // namespace

void make_allocator_frugal() {
#ifdef __GLIBC__
    // Each thread's own arena would keep what it once took; large arrays go back to the system as soon as they are freed, however large
    // those freed before were.
    ::mallopt(M_ARENA_MAX, 4);
    ::mallopt(M_MMAP_THRESHOLD, 512 << 10);
    ::mallopt(M_TRIM_THRESHOLD, 4 << 20);
#endif
}

void give_back_spare_heap() {
#ifdef __GLIBC__
    static std::atomic<std::chrono::steady_clock::rep> last{0};
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    auto before = last.load();
    if (now - std::chrono::steady_clock::duration(before) < between ||
        !last.compare_exchange_strong(before, now.count()))
        return;
    ::malloc_trim(0);
#endif
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool HeapRest::due(double processors, bool computing, Time now) {
    const double since = std::chrono::duration<double>(now - asked_).count();
    if (asked_ == Time{} || computing || processors - seen_ > quiet_share * since)
        quiet_since_ = now;
    seen_ = processors;
    asked_ = now;
    if (now - quiet_since_ < quiet_for || processors - done_ < work)
        return false;
    done_ = processors;
    return true;
}

} // namespace wakesurf::server
