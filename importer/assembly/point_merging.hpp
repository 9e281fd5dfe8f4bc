// Points of different pieces of a mesh at the same place are one node: the blocks of a multi-block mesh meet there, the parts of a decomposed
// one, and the cells of a file in which each has nodes of its own. Points of one piece never are: two of them at one place are the sides
// of a baffle.
#pragma once

#include "core/base/vec3.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace wakesurf::importer {

/// Points of all blocks, one after the other.
struct BlockPoints {
    std::vector<core::Vec3> at;
    std::vector<std::size_t> first;   ///< of each block, and the number of all
    std::vector<bool> used;           ///< by a cell
    std::vector<std::uint32_t> piece; ///< of cells that hang together by points of their block
    std::size_t pieces = 0;
    /// How far another point at the same place may be: the roundings of the coordinates, but a small part of the shortest edge there.
    std::vector<float> reach;
};

/// A face's points, by their numbers in BlockPoints.
using FacePoints = std::vector<std::uint32_t>;

/// The faces of all cells with a point for which `marked` is set.
using FacesAt = std::function<std::vector<FacePoints>(const std::vector<bool>& marked)>;

/// For every point the lowest one it is the same node as, itself where there is none. Where a place has several points of
/// one piece, which of them meets which is told by the faces that the pieces share there.
/// Cost: O(n log n) of the points that lie in the boxes of several pieces; of all where there are many pieces.
std::vector<std::uint32_t> merge_points(const BlockPoints& points, const FacesAt& faces_at);

} // namespace wakesurf::importer
