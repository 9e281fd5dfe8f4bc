// The processor time of a process, with all its threads: unlike wall-clock time it does not depend on other
// processes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <ctime>
#include <stdexcept>

namespace wakesurf::tests {

inline std::chrono::nanoseconds processor_time(clockid_t clock) {
    timespec used{};
    if (::clock_gettime(clock, &used) != 0)
        throw std::runtime_error("there is no such process");
    return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
}

/// Returns that of another process.
inline std::chrono::nanoseconds processor_time_of(pid_t process) {
    clockid_t clock{};
    if (::clock_getcpuclockid(process, &clock) != 0)
        throw std::runtime_error("there is no such process");
    return processor_time(clock);
}

/// Returns that of this process.
inline std::chrono::nanoseconds own_processor_time() {
    return processor_time(CLOCK_PROCESS_CPUTIME_ID);
}

} // namespace wakesurf::tests
