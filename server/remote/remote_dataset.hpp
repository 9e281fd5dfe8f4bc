// The files of a dataset's store: on a disk, on the web, or made of a Zarr on either. All that other rooms
// include of this one, so that a build without WAKESURF_REMOTE needs no libcurl, c-blosc or zstd.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "server/remote/web/web_address.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

/// The memory for chunks of a Zarr. Thread safety: concurrent calls are allowed.
struct ChunkMemory {
    /// The bound until `use` is called: one chunk of each component, and one that is read.
    std::size_t least = 0;
    std::function<void(std::size_t bytes)> use; ///< sets the bound. REQUIRES: at least `least`
};

struct OpenDisk {
    std::shared_ptr<const core::Disk> disk;
    std::optional<ChunkMemory> zarr; ///< none if it is no Zarr
};

/// Returns the bound on the kept data of a Zarr's scalars, for so much memory; scalars beyond it are left
/// out.
constexpr std::uint64_t scalar_bytes(std::uint64_t memory) {
    return memory / 8;
}

/// Whether a folder is, or lies in, one whose name ends in .zarr, or has a Zarr's metadata.
bool is_zarr(const std::filesystem::path& folder);

/// Whether the files are read-only and stay as they were when opened: a store on the web, or a Zarr.
bool is_others(const std::filesystem::path& folder);

/// Opens the disk; reads the metadata of a Zarr. Credentials are those of the environment.
/// @param scalar_bytes  as ZarrDisk::open. @param closing  ends all questions to a web server. Error: as
/// ZarrDisk::open; InvalidArgument if credentials would be sent unencrypted, or hold a line break;
/// Unsupported for the web and for a Zarr in a build without them.
core::Result<OpenDisk> open_disk(const std::filesystem::path& folder,
                                 std::uint64_t scalar_bytes,
                                 std::stop_token closing = {});

/// The part of open_disk() for the web and for a Zarr. REQUIRES: is_others(folder).
core::Result<OpenDisk> open_remote(const std::filesystem::path& folder,
                                   std::uint64_t scalar_bytes,
                                   std::stop_token closing);

} // namespace wakesurf::server
