// The words for NetCDF files that hold no velocity on a Cartesian grid: what they hold instead, and what to do.
#pragma once

#include "importer/sources/netcdf/netcdf_file.hpp"

namespace wakesurf::importer {

/// Returns the error of a file without a variable over x, y and z.
core::Error why_no_grid(const NetcdfFile& file);

/// Returns the error of a velocity whose components, by their standard names or their own, are on nodes of
/// their own: together they are a velocity nowhere. None if there is no such velocity.
std::optional<core::Error> staggered_velocity(const NetcdfFile& file);

} // namespace wakesurf::importer
