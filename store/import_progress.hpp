// The progress of an import: one line of JSON between wakesurf-import and the program that started it, or
// text for people.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

struct ImportProgress {
    std::string phase; ///< waiting, import (or what else is being done), or done
    std::size_t done = 0;
    std::size_t total = 0;
    std::string file;                  ///< the one just finished, without its folder
    std::string note;                  ///< for people; may be empty
    double part = 0.0;                 ///< of the one being worked on, 0..1; on a terminal only
    std::optional<double> remaining{}; ///< an estimate in s; empty while unknown
    /// The possible names of the velocity, if the import ends because that is not clear.
    std::vector<std::string> velocities{};
};

/// `{"phase":"import","done":3,"total":16,"file":"...","remaining":2.5}`, without a line end, and back.
std::string progress_line(const ImportProgress& progress);
std::optional<ImportProgress> parse_progress_line(std::string_view line);

/// A bar on a terminal, plain lines otherwise; `work` is the phase the lines are about.
void show_progress(const ImportProgress& progress,
                   std::FILE* stream,
                   std::string_view work = "import");

} // namespace wakesurf::store
