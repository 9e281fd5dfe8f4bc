// A uniform grid: nodes at origin + index * spacing, x fastest in memory.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

/// A grid of nodes at equal distances along each axis.
struct UniformGrid {
    Vec3 origin{0.0};  ///< the first node
    Vec3 spacing{1.0}; ///< from node to node along each axis, above 0
    std::array<std::uint32_t, 3> dimensions{2, 2, 2}; ///< nodes per axis, each at least 2

    /// Returns the number of nodes.
    std::size_t nodes() const { return std::size_t{dimensions[0]} * dimensions[1] * dimensions[2]; }

    /// Returns the box from the first node to the last.
    Box bounds() const {
        return {origin,
                origin + spacing * Vec3(dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1)};
    }
};

/// Returns whether coordinates along an axis, at least 2 and rising, are a uniform grid's but for rounding:
/// by no more than a millionth of the spacing, or the precision they are kept in.
bool is_even(std::span<const double> nodes, bool single_precision);

/// Returns the position of the node of a flat index, x fastest.
inline Vec3 node_position(const UniformGrid& grid, std::size_t node) {
    const std::size_t nx = grid.dimensions[0];
    const std::size_t ny = grid.dimensions[1];
    return grid.origin + grid.spacing * Vec3(node % nx, node / nx % ny, node / (nx * ny));
}

} // namespace wakesurf::core
