// An import runs in a process of its own that another one watches, which reads no file: what a hostile file can have the first
// one take, of memory and of time, and how it can end, is bounded and told in words here.
#pragma once

#include "core/base/result.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace wakesurf::importer {

struct ImportBounds {
    std::uint64_t memory = 0;         ///< bytes, of all processes of the import together
    std::chrono::seconds survey{60};  ///< without progress until the source is known; 0: no limit
    std::chrono::seconds stall{1800}; ///< the same afterwards
};

/// A quarter of what this process is granted: others share the machine.
std::uint64_t usual_import_memory();

/// From now on this process is interrupted when `parent`, which started it, ends. False where that has ended already.
bool end_with(int parent);

/// Runs `work` in a forked process and returns what it returns. Passes SIGINT and SIGTERM on to it. Whatever is left of
/// its processes is ended, also when this one is killed.
/// Error, in words that name `source`: OverLimit (memory), Io (too slow), Cancelled (a signal), Corrupt (it crashed).
core::Result<int> run_watched(const std::string& source,
                              const ImportBounds& bounds,
                              const std::function<int()>& work);

/// Completes an error about memory: what the bound is, and what to do.
core::Error with_memory_bound(core::Error error, std::uint64_t bound);

} // namespace wakesurf::importer
