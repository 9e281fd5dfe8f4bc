// A Zarr as a store in bricks: the files that a store would have are made of its chunks when they are read.
// So the store reader, its bricks and everything above are independent of Zarr.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/worker_threads.hpp"
#include "core/dataset/brick_layout.hpp"
#include "server/remote/zarr/chunk_cache.hpp"
#include "server/remote/zarr/zarr_dataset.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// A brick of a column's values, put together from the overlapping chunks of a Zarr: which part comes from
/// where. Values in, values out.
/// Describes the part of a brick that comes from one chunk.
struct BrickPiece {
    std::size_t array = 0;              ///< which of ZarrDataset::arrays
    std::vector<std::uint64_t> chunk;   ///< its place, one number an axis of the array
    std::vector<std::uint64_t> from;    ///< the first number in the chunk, likewise
    std::array<std::size_t, 3> first{}; ///< its node in the brick, x, y, z
    std::array<std::size_t, 3> count{}; ///< nodes along each
    std::size_t all_components = 1;     ///< numbers a node of the brick

    struct Component {
        std::size_t in_brick = 0; ///< among all_components
        std::uint64_t from = 0;   ///< beyond BrickPiece::from
    };

    std::vector<Component> components; ///< those that the chunk has
};

/// Returns all pieces of a brick, which together are its nodes that the grid has. REQUIRES: the column,
/// time-step and brick exist.
std::vector<BrickPiece> pieces_of(const ZarrDataset& dataset,
                                  const core::BrickLayout& layout,
                                  std::size_t column,
                                  std::size_t step,
                                  std::size_t brick);

/// Copies a piece into a brick. @param chunk  its numbers' bytes; empty: the fill value. @param brick  all
/// its numbers
/// @return false if some value is not finite
bool put_piece(const ZarrDataset& dataset,
               const core::BrickLayout& layout,
               const BrickPiece& piece,
               std::span<const std::byte> chunk,
               std::span<float> brick);

/// Repeats the last nodes of the grid in a brick's nodes beyond its end. @param components  numbers a node
void repeat_last(const core::BrickLayout& layout,
                 std::size_t brick,
                 std::size_t components,
                 std::span<float> values);

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
