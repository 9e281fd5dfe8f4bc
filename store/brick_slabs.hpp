// Nodes of a grid, x fastest, and its bricks: writers of a store have values in the one order, the disk has them in the other; and
// where the rows of a brick are among those of its grid.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/brick_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace wakesurf::store {

/// Takes memory for a layer of bricks, which of a grid of nx x ny nodes has 33 of their layers, and a brick.
/// That is 415 MB of a velocity of 1024 x 1024, 1.7 GB of 2048 x 2048, half of it in half precision.
class BrickSlabs {
  public:
    /// Takes a brick's bytes, valid until it returns. Layer by layer, in a layer in the order of the file.
    /// @param place  in the file
    using Put =
        std::function<core::Result<void>(std::size_t place, std::span<const std::byte> brick)>;

    BrickSlabs(const core::BrickLayout& layout, std::size_t node_bytes, Put put);

    /// The next bytes of the nodes, as many as there are. Error: of `put`. REQUIRES: no more than the grid
    /// has.
    core::Result<void> add(std::span<const std::byte> bytes);

    /// All nodes have come, and all bricks are put.
    bool complete() const { return layer_ == layout_.bricks()[2]; }

  private:
    core::Result<void> put_layer();
    std::size_t layer_bytes() const;

    core::BrickLayout layout_;
    std::size_t node_bytes_;
    Put put_;
    std::uint32_t layer_ = 0; ///< of bricks, the one that is filled
    std::vector<std::byte> slab_;
    std::size_t filled_ = 0; ///< bytes of slab_
    std::vector<std::byte> brick_;
};

/// Visits all rows of a brick: visit(first node in the brick, first node in the grid, nodes of the grid in
/// the row). Beyond the grid's end the last row is visited again; a row's further nodes in the brick repeat
/// its last one.
template <class Visit>
void for_rows_of(const core::BrickLayout& layout, std::size_t brick, Visit visit) {
    const auto first = layout.first_node(brick);
    const auto& grid = layout.dimensions();
    const auto& nodes = layout.brick_nodes();
    const auto count = std::min<std::size_t>(nodes[0], grid[0] - first[0]);
    std::size_t in_brick = 0;
    for (std::size_t k = 0; k < nodes[2]; ++k)
        for (std::size_t j = 0; j < nodes[1]; ++j, in_brick += nodes[0]) {
            const auto y = std::min<std::size_t>(first[1] + j, grid[1] - 1);
            const auto z = std::min<std::size_t>(first[2] + k, grid[2] - 1);
            visit(in_brick, first[0] + grid[0] * (y + grid[1] * z), count);
        }
}

} // namespace wakesurf::store
