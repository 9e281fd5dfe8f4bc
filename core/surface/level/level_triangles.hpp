// A level set of values at the nodes of a grid as triangles, by marching cells (Lorensen and Cline 1987) of
// all shapes.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/dataset/grid.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

struct LevelTriangles {
    std::vector<Vec3>
        points; ///< one on each edge between nodes below the level and nodes at or above it
    std::vector<std::array<std::uint32_t, 3>>
        triangles;            ///< counterclockwise seen from lower values
    std::uint64_t needed = 0; ///< triangles; where that is too many, none are made
};

/// Extracts the level set. Cells with a node whose value is not finite are left out. Where the cells share
/// faces, each directed edge of the triangles is used once, and its reverse too except on the border of the
/// cells; a value that is the level makes triangles without area. The order depends on no threads. Memory is
/// taken from `work` before it is used; what the result holds stays taken. REQUIRES: one value a node.
/// Error: OverLimit without memory, or for a grid of 2^32 nodes; Cancelled.
/// @param most  triangles that are made, at most 2^30
Result<LevelTriangles> level_triangles(const Grid& grid,
                                       std::span<const float> values,
                                       double level,
                                       std::uint64_t most,
                                       const std::stop_token& stop,
                                       const WorkPart& work);

} // namespace wakesurf::core
