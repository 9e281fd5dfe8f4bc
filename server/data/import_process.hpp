// Starts wakesurf-import beside our own executable and reads its output. A crash, or a hostile file, stays in
// its process; it gets no shell, no standard input and a bounded address space.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "store/command/source_options.hpp"
#include "store/import_progress.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct ImportCommand {
    std::filesystem::path source;
    std::filesystem::path store;
    std::vector<std::string> fields; ///< --fields; empty: chosen by the importer
    std::string times;               ///< --times; empty: all
    std::filesystem::path program{}; ///< empty: wakesurf-import beside our own executable
    std::string precision{};         ///< --precision; empty: single
    std::size_t jobs = 0;            ///< --jobs; 0: one a core
    std::uint64_t memory = 0;        ///< --memory, of all its processes; 0: its own bound
    command::SourceOptions taken{};  ///< --dt, --start, --periodic, --confined
    std::string layout{};            ///< --layout; empty: auto
    /// A server follows the source: a time-step that cannot be read yet is an error, and its time is kept.
    bool growing = false;
    std::vector<std::filesystem::path> secrets{}; ///< files and folders that it may not read
    /// Gets what libraries say, a sentence each, which may quote any file; then errors do not have it. Empty: errors
    /// have it.
    std::function<void(std::string_view)> library_words{};
};

/// Runs an import to its end in the calling thread, which calls `listener` for every step. When `stop` fires
/// the importer is ended; the store stays usable and a later import resumes there. Error: the importer's own
/// sentence (Corrupt), also about a file that is being written; Cancelled; Io if it cannot be started or
/// crashed.
core::Result<void>
run_import_process(const ImportCommand& command,
                   const std::function<void(const store::ImportProgress&)>& listener,
                   std::stop_token stop = {});

/// Describes a source without converting it: runs the importer with --describe. Error: as above.
core::Result<core::DatasetInfo> describe_with_import_process(const ImportCommand& command,
                                                             std::stop_token stop = {});

/// Reads the points of a rake from a file of a table or a line (importer/rake_file.hpp). Error: the importer's
/// own sentence. @param separate  they need not lie on one line
core::Result<std::vector<core::Vec3>>
read_rake_with_import_process(const std::filesystem::path& file, bool separate);

} // namespace wakesurf::server
