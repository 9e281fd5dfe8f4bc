// Types and numbers in the metadata of a Zarr's array. Used by server/remote/zarr/zarr_metadata.cpp alone.
#pragma once

#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string_view>

namespace wakesurf::server {

/// Reads "<f4", ">f8", "|u1", of version 2. Returns false for unsupported types.
bool read_zarr_type(ZarrArray& array, std::string_view text);

/// Reads "float32", "uint8", of version 3, which states the byte order elsewhere.
bool read_zarr_type_name(ZarrArray& array, std::string_view text);

/// Reads a fill_value; empty for null. Error: Corrupt.
core::Result<std::optional<double>> read_zarr_fill(const ZarrArray& array,
                                                   const nlohmann::json& value);

} // namespace wakesurf::server
