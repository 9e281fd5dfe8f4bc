// Is a NetCDF file as long as its header says? Asked before a library is trusted with one that was cut off.
// Format: NetCDF Classic Format Specification (CDF-1, CDF-2 and CDF-5); NetCDF-4 is HDF5.
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/files/source_files.hpp"

namespace wakesurf::importer {

/// Error: NotFound, Io, Corrupt (also what is no NetCDF at all). Cost: reads the header.
core::Result<void> check_netcdf_size(const NamedFile& file);

} // namespace wakesurf::importer
