// Points of different pieces of a mesh at the same place are one node: the blocks of a multi-block mesh meet
// there, the parts of a decomposed one, and the cells of a file in which each has nodes of its own. Points of
// one piece never are: two of them at one place are the sides of a baffle.
#pragma once

#include "core/base/vec3.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace wakesurf::importer {

/// Holds the points of all blocks, one block after the other.
struct BlockPoints {
    std::vector<core::Vec3> at;
    /// The index of the first point of each block, then the number of all points.
    std::vector<std::size_t> first;
    std::vector<bool> used;           ///< by a cell
    std::vector<std::uint32_t> piece; ///< of cells that hang together by points of their block
    std::size_t pieces = 0;
    /// The distance within which another point is at the same place: the roundings of the coordinates, but a
    /// small part of the shortest edge there.
    std::vector<float> reach;
};

/// A face's points, by their numbers in BlockPoints.
using FacePoints = std::vector<std::uint32_t>;

/// Returns the faces of all cells with a point for which `marked` is set.
using FacesAt = std::function<std::vector<FacePoints>(const std::vector<bool>& marked)>;

/// Returns for every point the lowest one of the same node, which may be itself. Where a place has several
/// points of one piece, the faces that two pieces share there decide which points are joined. Cost: O(n log
/// n) in the points that lie in the boxes of several pieces; in all points if there are many pieces.
std::vector<std::uint32_t> merge_points(const BlockPoints& points, const FacesAt& faces_at);

} // namespace wakesurf::importer
