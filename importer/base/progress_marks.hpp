// What an import shows the process that watches it (watched_process.hpp): a few numbers in memory that both see.
#pragma once

#include <atomic>
#include <cstdint>

namespace wakesurf::importer {

struct ProgressMarks {
    std::atomic<std::uint64_t> progress{
        0}; ///< rises with every file that was surveyed and every time-step converted
    std::atomic<bool> surveyed{false};      ///< what the source holds is known
    std::atomic<bool> out_of_memory{false}; ///< an allocation failed
};

/// Of this process and those it forks after the first call.
ProgressMarks& progress_marks();

/// A file was surveyed, a time-step converted, or another import is waited for: time limits start again.
void made_progress();

} // namespace wakesurf::importer
