// How the metadata of a Zarr's array write types and numbers. Used by server/service/zarr/zarr_metadata.cpp alone.
#pragma once

#include "core/base/result.hpp"
#include "server/service/zarr/zarr_array.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string_view>

namespace wakesurf::server {

/// "<f4", ">f8", "|u1", of version 2. False for what is not read.
bool read_zarr_type(ZarrArray& array, std::string_view text);

/// "float32", "uint8", of version 3, where the byte order is told elsewhere.
bool read_zarr_type_name(ZarrArray& array, std::string_view text);

/// A fill_value; nothing for null. Error: Corrupt.
core::Result<std::optional<double>> read_zarr_fill(const ZarrArray& array,
                                                   const nlohmann::json& value);

} // namespace wakesurf::server
