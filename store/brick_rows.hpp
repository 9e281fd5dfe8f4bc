// Where the rows of a brick's nodes are among those of its grid.
#pragma once

#include "core/dataset/brick_layout.hpp"

#include <algorithm>
#include <cstddef>

namespace wakesurf::store {

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
