// Formats that are not read, and what to do with a file in one: told by names and by the first bytes.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <optional>

namespace wakesurf::importer {

/// A format that is read whatever the file is called.
enum class Held { Netcdf, Cgns };

/// Tells the format of a file by what it holds: NetCDF of any version (not Exodus), CGNS in HDF5 or ADF.
std::optional<Held> held_format(const std::filesystem::path& file);

/// Returns the error of a file or folder of a known format that is not read: what it is, and which export is read.
/// None if it is of no known format. @param by_bytes  by its first bytes alone, where these are of no format that is read
std::optional<core::Error> other_format(const std::filesystem::path& path, bool by_bytes = false);

} // namespace wakesurf::importer
