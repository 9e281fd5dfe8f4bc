// What a source is made of: the files of its time-steps in order of time.
#pragma once

#include "core/base/result.hpp"
#include "protocol/store_manifest.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct SeriesFile {
    std::filesystem::path path;
    std::string name;           ///< for people: without the folder of the series
    std::optional<double> time; ///< as the series says it
};

struct Series {
    std::string name;   ///< of the dataset
    std::string reader; ///< of the whole: pvd, vti series or vti
    std::vector<SeriesFile> files;
    std::vector<std::filesystem::path> index; ///< files besides those of the time-steps: the .pvd
};

/// T0:T1[:EVERY] of --times: both ends included, every EVERY-th time-step.
struct TimeSelection {
    double from = 0.0;
    double to = 0.0;
    std::size_t every = 1;
};

core::Result<TimeSelection> parse_times(const std::string& text);

/// A .pvd, a .vti, or the first .vti of a numbered series (prefix + digits + .vti in one folder).
/// Error: NotFound, Io, Unsupported (other formats), Corrupt.
core::Result<Series> open_series(const std::filesystem::path& source);

/// Name, size and modification time of every file, for deciding whether an import is still good.
/// Error: NotFound naming the file that is missing, Io.
core::Result<std::vector<protocol::SourceFile>> fingerprint(const Series& series);

} // namespace wakesurf::server
