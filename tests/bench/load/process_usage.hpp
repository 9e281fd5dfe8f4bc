// What a process on this machine takes: memory and processor time, from /proc.
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace wakesurf::bench {

struct ProcessUsage {
    std::size_t resident_bytes = 0;
    double processor_seconds = 0.0;
};

/// Throws std::runtime_error when there is no such process.
ProcessUsage usage_of(pid_t process);

} // namespace wakesurf::bench
