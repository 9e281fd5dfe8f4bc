// Is a NetCDF file as long as its header says? The NetCDF library reads zeros behind the end of one that is not.
// Format: NetCDF Classic Format Specification (CDF-1, CDF-2 and CDF-5).
#pragma once

#include "core/base/result.hpp"
#include "server/import/sources/source_files.hpp"

namespace wakesurf::server {

/// Classic formats only; of NetCDF-4 nothing is checked, since HDF5 itself refuses files that are cut off.
/// Error: NotFound, Io, Corrupt. Cost: reads the header.
core::Result<void> check_netcdf_size(const NamedFile& file);

} // namespace wakesurf::server
