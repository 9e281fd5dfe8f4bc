// The memory of all processes below one, read from /proc since no limit of the kernel covers several; and
// checks of what a file claims to need, before any of it is read.
#pragma once

#include "core/base/result.hpp"

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns all processes below `process`, however deep, without itself. Cost: some 20 microseconds a process.
std::vector<pid_t> processes_below(pid_t process);

/// Returns the bytes that only swapping could take back: anonymous and shared memory, not the pages of
/// programs and files. Memory shared by forked processes counts for each: the sum is never too low. Cost:
/// some 20 microseconds a process.
std::uint64_t quick_memory(const std::vector<pid_t>& processes);

/// Returns the same sum, with shared memory counted once. Cost: the kernel walks the pages, some 3 ms a
/// gigabyte.
std::uint64_t exact_memory(const std::vector<pid_t>& processes);

/// Returns the bytes that a process has read from files and pipes; 0 if the system does not say.
std::uint64_t bytes_read_by(pid_t process);

/// Sets the memory that this process and those it starts may take from now on.
void set_memory_bound(std::uint64_t bytes);

/// Returns OverLimit if `count` values of `bytes` each are more than the bound. @param name  of the file that
/// says so
core::Result<void> check_claim(const std::string& name, std::uint64_t count, std::uint64_t bytes);

/// Returns Unsupported if the system does not show processes and their memory (no /proc).
core::Result<void> check_processes_show();

/// Returns the result of `read`. Error: OverLimit about `what`, if it needs more memory than there is.
template <class Read>
auto within_memory(const std::string& what, const Read& read) -> decltype(read()) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        return core::fail(core::Error::Code::OverLimit,
                          "there is not enough memory to read " + what);
    }
}

} // namespace wakesurf::importer
