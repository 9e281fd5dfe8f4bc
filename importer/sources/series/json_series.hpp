// A ParaView file series (flow.vtm.series, ...): JSON with a time for each file of a series.
// {"file-series-version": "1.0", "files": [{"name": "flow_0.vtm", "time": 0.5}, ...]}
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

/// Entries in the order of the file. Error: Io, Corrupt (not JSON, no files, a time that is not a finite number).
core::Result<FileSeries> read_json_series(const std::filesystem::path& file);

} // namespace wakesurf::importer
