// What the attributes of a Zarr's array say, by the conventions of CF and xarray: its unit, which numbers are no values, how values are scaled, and
// what its axes are called. Used by server/service/zarr/zarr_metadata.cpp alone.
#pragma once

#include "server/service/zarr/zarr_array.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// What is no attribute of that kind is passed over. REQUIRES: the array's shape, number and fill are known; the names of its axes, if they
/// are not among the attributes.
void read_zarr_attributes(ZarrArray& array, const nlohmann::json& given);

} // namespace wakesurf::server
