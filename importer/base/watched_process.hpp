// An import runs in a process of its own, watched by another one that reads no file. This bounds the memory
// and time that a hostile file can make it take, and puts its end into words.
#pragma once

#include "core/base/result.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct ImportBounds {
    std::uint64_t memory = 0;         ///< bytes, of all processes of the import together
    std::chrono::seconds survey{60};  ///< without progress before the source is known; 0: no limit
    std::chrono::seconds stall{1800}; ///< without progress afterwards; 0: no limit
};

/// Returns a quarter of the memory granted to this process, in bytes: others share the machine.
std::uint64_t usual_import_memory();

/// Interrupts this process when `parent`, which started it, ends. Returns false if that has ended already.
bool end_with(int parent);

/// Runs `work` in a forked process and returns its result. Passes SIGINT and SIGTERM on to it. All its
/// remaining processes are ended, also when this one is killed. Error, naming `source`: OverLimit (memory),
/// Io (too slow), Cancelled (a signal), Corrupt (it crashed).
core::Result<int> run_watched(const std::string& source,
                              const ImportBounds& bounds,
                              const std::function<int()>& work);

/// Adds to an error about memory what the bound is, and what to do.
core::Error with_memory_bound(core::Error error, std::uint64_t bound);

/// Returns all processes below `process`, however deep, without itself. Cost: some 20 microseconds a process.
std::vector<pid_t> processes_below(pid_t process);

/// Returns the bytes that only swapping could take back: anonymous and shared memory, not the pages of
/// programs and files. Memory shared by forked processes counts for each: the sum is never too low. Cost:
/// some 20 microseconds a process.
std::uint64_t quick_memory(const std::vector<pid_t>& processes);

/// Returns the same sum, with shared memory counted once. Cost: the kernel walks the pages, some 3 ms a
/// gigabyte.
std::uint64_t exact_memory(const std::vector<pid_t>& processes);

} // namespace wakesurf::importer
