// The objects of a Zarr's chunks, on a disk or the web, read whole and unpacked.
#pragma once

#include "core/base/disk.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Reads chunks. An object must keep the identity (size, time or ETag) of its first read: a Zarr has no
/// checksums of its own. Memory: some 100 bytes an object that was read. Errors name the chunk. Thread
/// safety: concurrent calls are allowed.
class ChunkObjects {
  public:
    ChunkObjects(std::filesystem::path root, std::shared_ptr<const core::Disk> disk)
        : root_(std::move(root)), disk_(std::move(disk)) {}

    /// Returns the bytes of a chunk's numbers; empty if there is no object and the array has a fill value.
    /// @param at  one number an axis
    /// Error: NotFound if there is neither, Corrupt if it is damaged or has changed, Io, Cancelled.
    core::Result<std::vector<std::byte>> read(const ZarrArray& array,
                                              const std::vector<std::uint64_t>& at,
                                              const std::stop_token& stop) const;

    /// Returns all values of an array of one axis. Error: likewise; OverLimit for more than `most`,
    /// and for more than 4096 objects.
    core::Result<std::vector<double>> read_line(const ZarrArray& array, std::uint64_t most) const;

    const core::Disk& disk() const { return *disk_; }

  private:
    core::Result<std::vector<std::byte>>
    read_object(const ZarrArray& array, const std::string& name, const std::stop_token& stop) const;
    core::Result<void> check_same(const std::string& name, const core::FileIdentity& now) const;

    std::filesystem::path root_;
    std::shared_ptr<const core::Disk> disk_;
    mutable std::mutex mutex_; ///< guards seen_
    mutable std::map<std::string, core::FileIdentity> seen_;
};

} // namespace wakesurf::server
