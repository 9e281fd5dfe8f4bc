// How long a classic NetCDF file must be: the library reads zeros beyond the end of one that was cut off.
// "NetCDF Classic Format Specification" (NetCDF users guide, appendix B): versions 1, 2 (64-bit offsets) and 5.
#pragma once

#include "server/import/sources/file_series.hpp"

namespace wakesurf::server {

/// Nothing to say of files that are not classic NetCDF. Error: Io, Corrupt (the header is damaged, or the file is shorter
/// than the variables its header lists).
core::Result<void> check_classic_netcdf_size(const ListedFile& file);

} // namespace wakesurf::server
