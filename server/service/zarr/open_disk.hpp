// The files of a dataset's store: on a disk, on the web, or made of a Zarr on either.
#pragma once

#include "server/service/zarr/zarr_disk.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace wakesurf::server {

struct OpenDisk {
    std::shared_ptr<const core::Disk> disk;
    std::shared_ptr<const ZarrDisk> zarr; ///< the same, where it is one; else null
};

/// Scalars of a Zarr are left out where what is kept of them takes more than this, of so much memory.
constexpr std::uint64_t scalar_bytes(std::uint64_t memory) {
    return memory / 8;
}

/// Of a Zarr it reads the metadata. @param scalar_bytes  as ZarrDisk::open. Error: as disk_of and ZarrDisk::open.
core::Result<OpenDisk> open_disk(const std::filesystem::path& folder, std::uint64_t scalar_bytes);

/// Nothing is ever written there, and it stays as it was when it was opened: a store on the web, or a Zarr.
bool is_others(const std::filesystem::path& folder);

} // namespace wakesurf::server
