// The format that a path is in, by its name and first bytes, and that format's reader; of formats that are not read, what to do.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "store/command/source_options.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace wakesurf::importer {

/// Opens `path` (a file, or any of a numbered series, or a pattern of one) with the reader of its format.
/// Error: NotFound, Io, Unsupported (listing the formats), Corrupt.
/// @param wish  the velocity asked for decides which blocks are fluid, and which fields every time-step must
/// have
core::Result<std::unique_ptr<Source>> open_source(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

/// A format that is read whatever the file is called.
enum class Held { Netcdf, Cgns };

/// Tells the format of a file by what it holds: NetCDF of any version (not Exodus), CGNS in HDF5 or ADF.
std::optional<Held> held_format(const std::filesystem::path& file);

/// Returns the error of a file or folder of a known format that is not read: what it is, and which export is read.
/// None if it is of no known format. @param by_bytes  by its first bytes alone, where these are of no format that is read
std::optional<core::Error> other_format(const std::filesystem::path& path, bool by_bytes = false);

} // namespace wakesurf::importer
