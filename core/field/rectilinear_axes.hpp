// Where points fall between the nodes of a rectilinear grid, axis by axis: what GridSampler asks of a grid.
// Twin: uniform_axes.hpp.
#pragma once

#include "core/dataset/grid.hpp"
#include "core/field/kernel/rk4_batch.hpp"
#include "core/field/uniform_axes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// A table of evenly spaced buckets for each axis gives the node to start from; a few steps from there find
/// the cell, or a binary search if a stretched grid has many nodes in a bucket. Thread safety: immutable.
/// Keeps a reference to the grid.
class RectilinearAxes {
  public:
    explicit RectilinearAxes(const RectilinearGrid& grid);
    RectilinearAxes(const RectilinearAxes&) = delete; // its tables point into it
    RectilinearAxes& operator=(const RectilinearAxes&) = delete;

    const Box& bounds() const { return bounds_; }

    const std::array<std::uint32_t, 3>& dimensions() const { return dimensions_; }

    double coordinate(std::size_t axis, std::size_t node) const {
        return axes_[axis].coordinate[node];
    }

    /// Returns what along() of a uniform grid does.
    AxisPoint along(std::size_t axis, double x) const {
        const Axis& a = axes_[axis];
        const std::size_t cell = a.cell(x);
        const double low = a.coordinate[cell];
        const double fraction = (x - low) / (a.coordinate[cell + 1] - low);
        return {cell, std::min(std::max(0.0, fraction), 1.0)};
    }

    /// The axes as the batch kernel takes them.
    const AxisTable* tables() const { return tables_.data(); }

    /// Returns the bytes of the tables.
    std::size_t bytes() const;

  private:
    struct Axis {
        const double* coordinate;
        std::size_t last; ///< cell
        double per_bucket;
        /// Each bucket's first cell; it has one more entry than there are buckets.
        std::vector<std::uint32_t> start;
        std::vector<CellReach> reach; ///< by cell

        std::size_t cell(double x) const;
    };

    std::array<Axis, 3> axes_;
    std::array<AxisTable, 3> tables_;
    std::array<std::uint32_t, 3> dimensions_;
    Box bounds_;
};

inline std::size_t RectilinearAxes::Axis::cell(double x) const {
    constexpr std::size_t few = 8;
    const std::size_t buckets = start.size() - 1;
    const double at = (x - coordinate[0]) * per_bucket;
    const std::size_t bucket =
        at > 0.0 ? static_cast<std::size_t>(std::min(at, static_cast<double>(buckets - 1))) : 0;
    std::size_t i = start[bucket];
    if (const std::size_t end = start[bucket + 1] + 1; end - i > few)
        i = static_cast<std::size_t>(std::upper_bound(coordinate + i + 1, coordinate + end, x) -
                                     coordinate) -
            1;
    while (i < last && x >= coordinate[i + 1]) // the bucket may be off by rounding
        ++i;
    while (i > 0 && x < coordinate[i])
        --i;
    return i;
}

inline const std::array<std::uint32_t, 3>& dimensions(const RectilinearAxes& grid) {
    return grid.dimensions();
}

inline AxisPoint along(const RectilinearAxes& grid, std::size_t axis, double coordinate) {
    return grid.along(axis, coordinate);
}

inline Vec3 cell_origin(const RectilinearAxes& grid, const std::array<std::size_t, 3>& cell) {
    return {grid.coordinate(0, cell[0]), grid.coordinate(1, cell[1]), grid.coordinate(2, cell[2])};
}

inline Vec3 cell_size(const RectilinearAxes& grid, const std::array<std::size_t, 3>& cell) {
    return cell_origin(grid, {cell[0] + 1, cell[1] + 1, cell[2] + 1}) - cell_origin(grid, cell);
}

} // namespace wakesurf::core
