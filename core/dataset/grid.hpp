// The grid of a dataset as its source has it: nothing is resampled. What kind it is decides how it is sampled
// (core/field).
#pragma once

#include "core/base/box.hpp"
#include "core/dataset/cell_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace wakesurf::core {

/// Nodes at origin + index * spacing, x fastest in memory.
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

/// Axis-aligned, with node coordinates of its own on each axis; x fastest in memory.
struct RectilinearGrid {
    std::array<std::vector<double>, 3> coordinates; ///< strictly increasing, at least 2 an axis

    /// Returns the number of nodes.
    std::size_t nodes() const {
        return coordinates[0].size() * coordinates[1].size() * coordinates[2].size();
    }

    /// Returns the box from the first node to the last.
    Box bounds() const {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& along = coordinates[static_cast<std::size_t>(axis)];
            box.lo[axis] = along.front();
            box.hi[axis] = along.back();
        }
        return box;
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

using Grid = std::variant<UniformGrid, RectilinearGrid, CellMesh>;

std::size_t node_count(const Grid& grid);
std::size_t cell_count(const Grid& grid);

/// Returns the position of a node of the values in memory. REQUIRES: node < node_count(grid).
Vec3 node_position(const Grid& grid, std::size_t node);

/// Returns the bytes of its arrays.
std::size_t memory_of(const Grid& grid);

/// Returns the box round all nodes.
Box bounds(const Grid& grid);

/// Finest detail a surface should resolve: the closest nodes on an axis; of a cell mesh the size of its
/// smaller cells (a tenth are smaller: boundary layers have cells much flatter than what surfaces are drawn
/// with).
double finest_spacing(const Grid& grid);

} // namespace wakesurf::core
