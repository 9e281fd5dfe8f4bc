// What a reader does for the process that watches it (watched_process.hpp): it reports progress, and fails early and by name
// where a file asks for more memory than there is.
#pragma once

#include "core/base/result.hpp"

#include <atomic>
#include <cstdint>
#include <new>
#include <string>

namespace wakesurf::importer {

/// The progress of an import, in memory that it shares with the watching process.
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

/// Sets the memory that this process and those it starts may take from now on.
void set_memory_bound(std::uint64_t bytes);

/// Returns OverLimit if `count` values of `bytes` each are more than the bound. @param name  of the file that
/// says so
core::Result<void> check_claim(const std::string& name, std::uint64_t count, std::uint64_t bytes);

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
