#include "server/live/compute/thread_priority.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <ctime>

namespace wakesurf::server {

namespace {

/// sched_setattr(2); the C library has neither.
struct SchedulerAttributes {
    std::uint32_t size = sizeof(SchedulerAttributes);
    std::uint32_t policy = SCHED_OTHER;
    std::uint64_t flags = 0;
    std::int32_t nice = 0;
    std::uint32_t priority = 0;
    std::uint64_t runtime = 0; ///< ns: of a slice
    std::uint64_t deadline = 0;
    std::uint64_t period = 0;
};

constexpr std::uint64_t short_slice = 500'000; // the kernel's own: about 3 ms

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

int own_thread_id() {
    return static_cast<int>(syscall(SYS_gettid));
}

void step_back(int niceness, int thread) {
    setpriority(PRIO_PROCESS, static_cast<id_t>(thread == 0 ? own_thread_id() : thread), niceness);
}

void ask_for_short_slices() {
    SchedulerAttributes attributes;
    attributes.nice = getpriority(PRIO_PROCESS, static_cast<id_t>(own_thread_id()));
    attributes.runtime = short_slice;
    syscall(SYS_sched_setattr, 0, &attributes, 0u);
}

double processor_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double processor_seconds(std::thread::native_handle_type thread) {
    clockid_t clock{};
    return pthread_getcpuclockid(thread, &clock) == 0 ? seconds_of(clock) : 0.0;
}

} // namespace wakesurf::server
