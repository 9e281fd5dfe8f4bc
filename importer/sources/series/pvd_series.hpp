// A ParaView collection (.pvd): a small XML file with a time for each file of a series. Several files of one
// time are parts of that time-step.
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

/// Entries in order of time, parts in the order of the file. Error: Corrupt (not XML, no DataSet, times that are no
/// numbers, one part twice at one time), Unsupported (time-steps of different numbers of parts).
core::Result<FileSeries> read_pvd_series(const std::filesystem::path& file);

} // namespace wakesurf::importer
