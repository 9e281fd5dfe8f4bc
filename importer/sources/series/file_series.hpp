// A source that is a list of files: those of each time-step, and the times that the list states. Lists are ParaView's collections
// (.pvd) and file series (flow.vtm.series, ...).
#pragma once

#include "core/base/result.hpp"
#include "store/store_manifest.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct ListedFile {
    std::filesystem::path path;
    /// The name for people: as the series names it, without its folder.
    std::string name;
    /// Names the part, if the series has one.
    std::string block;
};

struct SeriesEntry {
    /// Holds all files of one time-step, at least one.
    std::vector<ListedFile> parts;
    std::optional<double> time;
    /// The number in the file's name.
    std::optional<double> number{};
};

struct FileSeries {
    /// The name of the dataset.
    std::string name;
    /// The kind: pvd, vtm.series, vtu series, vtu and the like.
    std::string kind;
    /// The file that lists the others, if there is one.
    std::vector<std::filesystem::path> index;
    /// The time-steps in order, at least one.
    std::vector<SeriesEntry> entries;
    /// The names of files of parts that the list names again for the same time.
    std::vector<std::string> left_out{};
    /// Says that the list was cut off; else empty.
    std::string note{};
};

/// Finds the series of `source`: a .pvd, a .series, any file of a numbered series or a pattern of one, a file
/// alone. The files need not exist yet. Error: NotFound, Io, Corrupt, InvalidArgument.
/// @param alone  takes of a numbered series only the file that is named
core::Result<FileSeries> open_file_series(const std::filesystem::path& source, bool alone);

/// Reads JSON with a time for each file:
/// {"file-series-version": "1.0", "files": [{"name": "flow_0.vtm", "time": 0.5}, ...]}. Entries stay in the
/// order of the file. Of a list that was cut off, or is still written, those count that are whole. Error: Io,
/// Corrupt (not JSON, no files, a time that is not a finite number).
core::Result<FileSeries> read_json_series(const std::filesystem::path& file);

/// Reads a small XML file with a time for each file; several files of one time are parts of that time-step.
/// Entries come in order of time, parts in the order of the file. Of a list that was cut off, or is still
/// written, the time-steps count that are whole. Error: Corrupt (not XML, no DataSet, times
/// that are no numbers, one part twice at one time).
core::Result<FileSeries> read_pvd_series(const std::filesystem::path& file);

/// Returns what fingerprint of files/source_files.hpp does, and fails as it does.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<ListedFile>& files);

} // namespace wakesurf::importer
