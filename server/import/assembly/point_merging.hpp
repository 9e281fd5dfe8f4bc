// Points of different blocks at the same place are one node: the pieces of a decomposed mesh and the blocks of a
// multi-block one meet there. Points of one block never are: two of them at one place are the sides of a baffle.
#pragma once

#include "core/base/vec3.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace wakesurf::server {

/// Points of all blocks, one after the other.
struct BlockPoints {
    std::vector<core::Vec3> at;
    std::vector<std::size_t> first; ///< of each block, and the number of all
    std::vector<bool> used;         ///< by a cell
};

struct BlockFace {
    std::uint32_t block = 0;
    std::vector<std::uint32_t> points; ///< numbers in BlockPoints
};

/// The faces of all cells with a point for which `marked` is set.
using FacesAt = std::function<std::vector<BlockFace>(const std::vector<bool>& marked)>;

/// For every point the lowest one it is the same node as, itself where there is none. Where a place has several points of
/// one block, which of them meets which is told by the faces that the blocks share there.
/// Cost: O(n log n) of the points that lie in the boxes of several blocks.
std::vector<std::uint32_t>
merge_points(const BlockPoints& points, double tolerance, const FacesAt& faces_at);

} // namespace wakesurf::server
