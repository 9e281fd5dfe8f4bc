// Masks in one piece and in bricks, one made of the other.
#pragma once

#include "core/dataset/solid_mask.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::tests {

/// Returns a byte a node, x fastest, of either.
inline std::vector<std::uint8_t> mask_bytes(const core::SolidMask& mask, std::size_t nodes) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t node = 0; !mask.empty() && node < nodes; ++node)
        bytes.push_back(mask.is_fluid(node) ? 1 : 0);
    return bytes;
}

/// Returns the mask in bricks; nodes beyond the grid repeat its last ones, as in stores.
inline core::SolidMask mask_in_bricks(const core::SolidMask& whole,
                                      const core::BrickLayout& layout) {
    if (whole.empty())
        return {};
    const auto& grid = layout.dimensions();
    const auto& nodes = layout.brick_nodes();
    core::BrickBytes bricks(layout);
    for (std::size_t brick = 0; brick < layout.count(); ++brick) {
        const auto first = layout.first_node(brick);
        const auto along = [&](std::size_t axis, std::size_t i) {
            return std::min<std::size_t>(first[axis] + i, grid[axis] - 1);
        };
        std::vector<std::uint8_t> bytes;
        for (std::size_t z = 0; z < nodes[2]; ++z)
            for (std::size_t y = 0; y < nodes[1]; ++y)
                for (std::size_t x = 0; x < nodes[0]; ++x)
                    bytes.push_back(
                        whole.fluid[along(0, x) + grid[0] * (along(1, y) + grid[1] * along(2, z))]);
        bricks.set(brick, bytes);
    }
    return {{}, std::make_shared<const core::BrickBytes>(std::move(bricks))};
}

} // namespace wakesurf::tests
