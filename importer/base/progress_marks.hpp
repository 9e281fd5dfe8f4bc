// The progress of an import for the process that watches it (watched_process.hpp): a few numbers in shared
// memory.
#pragma once

#include <atomic>
#include <cstdint>

namespace wakesurf::importer {

struct ProgressMarks {
    /// Rises with every file that was surveyed and every time-step that was converted.
    std::atomic<std::uint64_t> progress{0};
    std::atomic<bool> surveyed{false};      ///< the content of the source is known
    std::atomic<bool> out_of_memory{false}; ///< an allocation failed
};

/// Returns the marks of this process and of those it forks after the first call.
ProgressMarks& progress_marks();

/// Restarts time limits: a file was surveyed, a time-step converted, or another import is waited for.
void made_progress();

} // namespace wakesurf::importer
