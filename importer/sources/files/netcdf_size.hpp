// Checks the length of a NetCDF file against its header, before a library reads a file that was cut off.
// Format: NetCDF Classic Format Specification (CDF-1, CDF-2 and CDF-5); NetCDF-4 is HDF5.
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/files/source_files.hpp"

namespace wakesurf::importer {

/// Checks the length. Error: NotFound, Io, Corrupt (also for a file that is no NetCDF). Cost: reads the
/// header.
core::Result<void> check_netcdf_size(const NamedFile& file);

} // namespace wakesurf::importer
