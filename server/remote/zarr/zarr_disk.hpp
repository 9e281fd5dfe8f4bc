// A Zarr as a store in bricks: the files that a store would have are made of its chunks when they are read.
// So the store reader, its bricks and everything above are independent of Zarr.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/worker_threads.hpp"
#include "core/dataset/brick_layout.hpp"
#include "server/remote/zarr/brick_pieces.hpp"
#include "server/remote/zarr/chunk_cache.hpp"
#include "server/remote/zarr/zarr_dataset.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Reads a Zarr. Thread safety: concurrent calls are allowed.
class ZarrDisk final : public core::Disk {
  public:
    /// Reads the metadata and the coordinates. @param disk  of the Zarr
    /// @param scalar_bytes  as in describe_zarr. Error: as read_zarr_group and describe_zarr.
    static core::Result<std::shared_ptr<const ZarrDisk>>
    open(const std::filesystem::path& root,
         std::shared_ptr<const core::Disk> disk,
         std::uint64_t scalar_bytes);

    core::Result<std::uint64_t> size(const std::filesystem::path& file) const override;
    core::Result<void> read(const std::filesystem::path& file,
                            std::uint64_t offset,
                            std::span<std::byte> out) const override;
    core::Result<void> read_stoppable(const std::filesystem::path& file,
                                      std::uint64_t offset,
                                      std::span<std::byte> out,
                                      const std::stop_token& stop) const override;

    Pace pace() const override { return objects_->disk().pace(); }

    /// Returns the least memory for chunks, the bound until use_memory() is called: one of each component,
    /// and one that is read.
    std::size_t least_memory() const;

    /// Sets the memory for chunks. REQUIRES: at least least_memory().
    void use_memory(std::size_t bytes) const { chunks_.resize(bytes); }

  private:
    /// Names the values that a file has.
    struct Values {
        std::size_t column;
        std::size_t step;
    };

    ZarrDisk(ZarrDataset dataset, std::unique_ptr<const ChunkObjects> objects, std::uint32_t mark);
    std::optional<Values> values_of(const std::filesystem::path& file) const;
    core::Result<void> read_bricks(const Values& values,
                                   std::size_t place,
                                   std::span<float> out,
                                   const std::stop_token& stop) const;
    core::Result<void> put(const BrickPiece& piece,
                           bool velocity,
                           std::span<float> brick,
                           const std::stop_token& stop) const;

    ZarrDataset dataset_;
    std::unique_ptr<const ChunkObjects> objects_;
    core::BrickLayout layout_;
    std::map<std::string, std::vector<std::byte>> files_; ///< all but the values
    mutable ChunkCache chunks_;
    mutable core::WorkerThreads threads_; ///< destroyed first: they use the members above
};

} // namespace wakesurf::server
