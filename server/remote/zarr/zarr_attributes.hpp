// The attributes of a Zarr's array, by the conventions of CF and xarray: its unit, its missing values, scale
// and offset, and the names of its axes. Used by server/remote/zarr/zarr_metadata.cpp alone.
#pragma once

#include "server/remote/zarr/zarr_array.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// Reads the attributes; unknown and malformed ones are ignored. REQUIRES: the array's shape, number and fill
/// are known; the names of its axes, unless they are among the attributes.
void read_zarr_attributes(ZarrArray& array, const nlohmann::json& given);

} // namespace wakesurf::server
