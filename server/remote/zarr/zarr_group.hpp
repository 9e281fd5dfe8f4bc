// The arrays of a Zarr: of the group at its root, or the one that is its root. They come from its
// consolidated metadata if there are any, else from those of each array.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ZarrGroup {
    std::vector<ZarrArray> arrays;              ///< by name
    std::map<std::string, core::Error> refused; ///< arrays that cannot be read, by name, and why
    int version = 2;                            ///< of Zarr
    bool listed = true;     ///< false: only the usual names of a velocity's arrays were tried
    std::uint32_t mark = 0; ///< CRC-32C of all metadata

    const ZarrArray* find(const std::string& name) const;
};

/// Reads the group. Error: NotFound without a Zarr, Io, and as parse_zarr_2 and parse_zarr_3 if the root is
/// an array itself.
/// @param names  folders below the root, if they can be listed
core::Result<ZarrGroup> read_zarr_group(const std::filesystem::path& root,
                                        const core::Disk& disk,
                                        const std::optional<std::vector<std::string>>& names);

} // namespace wakesurf::server
