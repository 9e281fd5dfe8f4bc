// The files of a dataset's store: on a disk, on the web, or made of a Zarr on either.
#pragma once

#include "server/service/zarr/zarr_disk.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace wakesurf::server {

struct OpenDisk {
    std::shared_ptr<const core::Disk> disk;
    std::shared_ptr<const ZarrDisk> zarr; ///< the same as a Zarr; null if it is none
};

/// Returns the bound on the kept data of a Zarr's scalars, for so much memory; scalars beyond it are left
/// out.
constexpr std::uint64_t scalar_bytes(std::uint64_t memory) {
    return memory / 8;
}

/// Opens the disk; reads the metadata of a Zarr. @param scalar_bytes  as ZarrDisk::open. Error: as disk_of
/// and ZarrDisk::open.
core::Result<OpenDisk> open_disk(const std::filesystem::path& folder,
                                 std::uint64_t scalar_bytes,
                                 std::stop_token closing = {});

/// Says whether the files are read-only and stay as they were when opened: a store on the web, or a Zarr.
bool is_others(const std::filesystem::path& folder);

} // namespace wakesurf::server
