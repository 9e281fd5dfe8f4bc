// The memory and processor time of a process on this machine, from /proc.
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace wakesurf::bench {

struct ProcessUsage {
    std::size_t resident_bytes = 0;
    double processor_seconds = 0.0;
};

/// Returns the usage. Throws std::runtime_error if there is no such process.
ProcessUsage usage_of(pid_t process);

} // namespace wakesurf::bench
