// How much memory the processes below one take together: read from /proc, since no limit of the kernel covers
// several. And what a file claims to need, held against what they may take before anything of it is read.
#pragma once

#include "core/base/result.hpp"

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// All processes below `process`, however deep, without itself. Cost: some 20 microseconds a process.
std::vector<pid_t> processes_below(pid_t process);

/// Bytes that only swapping could take back: anonymous and shared memory, not the pages of programs and
/// files. What forked processes share counts for each of them: never too little. Cost: some 20 microseconds a
/// process.
std::uint64_t quick_memory(const std::vector<pid_t>& processes);

/// The same, where what they share counts once. Cost: the kernel walks their pages, some 3 ms a gigabyte.
std::uint64_t exact_memory(const std::vector<pid_t>& processes);

/// What a process has read from files and pipes, in bytes; 0 where the system does not say.
std::uint64_t bytes_read_by(pid_t process);

/// What this process and those it starts may take from now on.
void set_memory_bound(std::uint64_t bytes);

/// Error: OverLimit, where `count` values of `bytes` each are more than the bound. @param name  of the file
/// that says so
core::Result<void> check_claim(const std::string& name, std::uint64_t count, std::uint64_t bytes);

/// Error: Unsupported, where the system does not show processes and their memory (no /proc).
core::Result<void> check_processes_show();

/// Returns what `read` does. Error: OverLimit about `what`, where it needs more memory than there is.
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
