// The nodes of a uniform or a rectilinear grid that lie inside an obstacle. The wall is where the trilinear
// fluid fraction falls below one half: midway between a fluid and a solid node.
#pragma once

#include "core/dataset/brick_bytes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::core {

/// A byte a node, 1 fluid or 0 solid, in one piece or in bricks. With neither there is no obstacle.
struct SolidMask {
    std::vector<std::uint8_t> fluid;                    ///< in one piece, x fastest
    std::shared_ptr<const BrickBytes> bricks = nullptr; ///< of a grid in bricks

    /// Says whether no node is solid.
    bool empty() const { return fluid.empty() && bricks == nullptr; }

    /// @param node   its place on each axis
    /// @param index  the same, x fastest
    bool is_fluid(const std::array<std::size_t, 3>& node, std::size_t index) const {
        return (bricks != nullptr ? bricks->of(node) : fluid[index]) != 0;
    }

    /// Returns whether the node of a flat index is fluid, at the cost of three divisions where it is in
    /// bricks.
    bool is_fluid(std::size_t index) const {
        if (bricks == nullptr)
            return fluid[index] != 0;
        const auto place = bricks->layout().place_of(index);
        return bricks->at(place.brick)[place.node] != 0;
    }

    /// Returns the bytes of memory that it takes.
    std::size_t bytes() const { return bricks != nullptr ? bricks->bytes() : fluid.size(); }
};

} // namespace wakesurf::core
