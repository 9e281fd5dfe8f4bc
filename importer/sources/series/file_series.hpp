// A source that is a list of files: which belong to which time-step, and the times the list has for them.
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
    std::string name;  ///< for people: as the series names it, without its folder
    std::string block; ///< name of the part it is, where the series has one
};

struct SeriesEntry {
    std::vector<ListedFile> parts; ///< all of one time-step, at least one
    std::optional<double> time;
    std::optional<double> number{}; ///< in the file's name
};

struct FileSeries {
    std::string name;                         ///< of the dataset
    std::string kind;                         ///< pvd, vtm.series, vtu series, vtu
    std::vector<std::filesystem::path> index; ///< the file that lists the others, if there is one
    std::vector<SeriesEntry> entries;         ///< in order, at least one
    std::vector<std::string>
        left_out{}; ///< files of parts that the list names again for the same time
};

/// `source`: a .pvd, a .series, any file of a numbered series or a pattern of one, a file alone. The files need not
/// exist yet. Error: NotFound, Io, Corrupt, InvalidArgument.
/// @param alone  of a numbered series only the file that is named
core::Result<FileSeries> open_file_series(const std::filesystem::path& source, bool alone);

/// As of files/source_files.hpp.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<ListedFile>& files);

/// Of files that hold several time-steps each: a single one is shared by all of them, of several each time-step has its own.
/// Error: as fingerprint.
core::Result<std::vector<store::SourceFile>> file_of_all(const FileSeries& series);
core::Result<std::vector<store::SourceFile>> file_of_one(const FileSeries& series,
                                                         std::size_t entry);

} // namespace wakesurf::importer
