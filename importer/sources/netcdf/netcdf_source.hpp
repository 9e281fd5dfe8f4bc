// NetCDF-CF files (.nc) on Cartesian grids: each variable is a field of one component, so u, v and w are three; one file
// of several time-steps, or numbered files of one or more each.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

/// By extension: .nc, .nc4, .cdf.
bool is_netcdf(const std::filesystem::path& path);

/// One block: an image where the nodes are evenly spaced (to a millionth of the spacing, or to what single precision
/// keeps of a coordinate), else a rectilinear grid. Fill values, missing values and those outside the valid range are
/// NaN. Reads the first time-step. Error: as open_source.
core::Result<std::unique_ptr<Source>> open_netcdf(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
