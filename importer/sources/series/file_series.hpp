// A source that is a list of files: which belong to which time-step, and the times that the list states.
#pragma once

#include "importer/sources/series/listed_series.hpp"
#include "store/store_manifest.hpp"

namespace wakesurf::importer {

/// Finds the series of `source`: a .pvd, a .series, any file of a numbered series or a pattern of one, a file
/// alone. The files need not exist yet. Error: NotFound, Io, Corrupt, InvalidArgument.
/// @param alone  takes of a numbered series only the file that is named
core::Result<FileSeries> open_file_series(const std::filesystem::path& source, bool alone);

/// Returns what fingerprint of files/source_files.hpp does, and fails as it does.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<ListedFile>& files);

} // namespace wakesurf::importer
