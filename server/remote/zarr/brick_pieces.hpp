// A brick of a column's values, put together from the overlapping chunks of a Zarr: which part comes from
// where. Values in, values out; server/remote/zarr/zarr_disk.hpp reads chunks.
#pragma once

#include "core/dataset/brick_layout.hpp"
#include "server/remote/zarr/zarr_dataset.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::server {

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

} // namespace wakesurf::server
