// A rectilinear grid: axis-aligned, with its own node coordinates on each axis; x fastest in memory.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace wakesurf::core {

/// A grid whose nodes are where the planes of three axes meet.
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

} // namespace wakesurf::core
