// The metadata of a Zarr's array -> values: version 2 (.zarray, .zattrs) and 3 (zarr.json). The text is
// untrusted, and all of it is checked here.
#pragma once

#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace wakesurf::server {

/// Parse the metadata of an array. Error: Corrupt for anything but a description of an array, Unsupported for
/// unsupported kinds: Fortran order, filters, shards, other codecs and types; OverLimit for chunks of more
/// than 2 GiB and more numbers than can be counted. To be read behind the array's name.
core::Result<ZarrArray>
parse_zarr_2(std::string name, const nlohmann::json& array, const nlohmann::json& attributes);
core::Result<ZarrArray> parse_zarr_3(std::string name, const nlohmann::json& array);

/// Parses metadata as Python writes them: NaN and Infinity become null. Error: as protocol::parse_json.
core::Result<nlohmann::json> parse_zarr_json(std::string_view text);

} // namespace wakesurf::server
