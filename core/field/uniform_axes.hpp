// Where points fall between the nodes of a uniform grid, axis by axis: what GridSampler asks of a grid.
// Twin: rectilinear_axes.hpp.
#pragma once

#include "core/dataset/grid.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace wakesurf::core {

/// A cell along one axis, and how far through it a coordinate is, 0 to 1.
struct AxisPoint {
    std::size_t cell;
    double fraction;
};

inline const std::array<std::uint32_t, 3>& dimensions(const UniformGrid& grid) {
    return grid.dimensions;
}

/// Returns the cell of a coordinate and the fraction in it. Coordinates beyond the border get the nearest
/// cell and fractions clamped to it. NaN counts as the lower border.
inline AxisPoint along(const UniformGrid& grid, std::size_t axis, double coordinate) {
    const auto i = static_cast<int>(axis);
    const double cells = grid.dimensions[axis] - 1;
    const double x =
        std::min(std::max(0.0, (coordinate - grid.origin[i]) / grid.spacing[i]), cells);
    const auto cell = static_cast<std::size_t>(std::min(x, cells - 1.0));
    return {cell, x - static_cast<double>(cell)};
}

inline Vec3 cell_size(const UniformGrid& grid, const std::array<std::size_t, 3>&) {
    return grid.spacing;
}

inline Vec3 cell_origin(const UniformGrid& grid, const std::array<std::size_t, 3>& cell) {
    return grid.origin + grid.spacing * Vec3(cell[0], cell[1], cell[2]);
}

} // namespace wakesurf::core
