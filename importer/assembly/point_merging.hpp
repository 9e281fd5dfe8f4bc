// Which points of a mesh are one node. Points of different pieces at the same place are: the blocks of a multi-block mesh meet
// there, the parts of a decomposed one, and the cells of a file in which each has nodes of its own. Points of one piece never
// are: two of them at one place are the sides of a baffle. Where velocities differ, points stay apart: two fluids with a mesh
// each in one file, or the sides of a sheet that slips. Where a flow repeats, nodes on opposite sides are one.
#pragma once

#include "core/base/periodic_axes.hpp"
#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/grid.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::importer {

/// Sets of the numbers below a size, joined two at a time (union-find).
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::size_t size() const { return parent_.size(); }

    /// Returns the lowest number of the set that `i` is in.
    std::uint32_t lowest(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = lowest(a);
        b = lowest(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

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

/// Holds pairs of points of several pieces at one place, by numbers that count through the blocks.
///
/// Two points are one node unless their velocities differ, at any time-step, by more than a fiftieth of the
/// highest speed and by more than four times what they change by along the edges of cells that lead away from
/// there, in the direction of the jump. A piece of fewer cells than there are pieces is an element of a discontinuous
/// method, at whose faces all values jump: its points are one node with others always.
class MeetingPoints {
  public:
    /// @param same  the lowest point of the same place, of each. @param piece  of each; `cells` of each piece
    MeetingPoints(std::span<const std::uint32_t> same,
                  std::span<const std::uint32_t> piece,
                  const std::vector<std::uint32_t>& cells);
    MeetingPoints() = default;

    bool empty() const { return pairs_.empty(); }

    /// Takes an edge of a cell; all must be given, in whatever order.
    void add_edge(std::uint32_t p, std::uint32_t q);

    /// Takes the velocities of all points at one time-step into account.
    void take(std::span<const float> velocity);

    /// Returns true if points that are one node would not be so at a time-step.
    bool tears(std::span<const float> velocity) const;

    /// Joins the points that are one node by all velocities that were taken into account.
    void join(DisjointSets& nodes) const;

    /// Forgets pairs that are not one node in `same`.
    void keep_joined(std::span<const std::uint32_t> same);

    /// Returns the largest difference between points that are one node in `same`, or that are not; 0 without a
    /// pair, or where it is a matter of rounding.
    double largest(std::span<const std::uint32_t> same, bool joined) const;

  private:
    struct Pair {
        std::uint32_t a, b;
        bool of_elements; ///< one is of an element
        bool agrees = true;
        float most = 0.0f; ///< by which they differed
    };

    struct Velocities;
    bool agree(const Pair& pair, const Velocities& velocities) const;

    std::vector<Pair> pairs_;
    /// A point of a pair and the other end of an edge there; sorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near_;
    std::vector<bool> wanted_;
    float highest_ = 0.0f; ///< speed
};

/// Pairs of nodes at the same place of opposite sides of a box; first that of the side of lower coordinates.
using OppositeNodes = std::vector<std::array<std::uint32_t, 2>>;

/// Returns the pairs along one axis, along which the flow repeats. Error, to be read after the file's name: Unsupported where a node of one side has
/// none on the other.
/// @param nodes  the number of nodes that count, the first ones
core::Result<OppositeNodes>
opposite_nodes(const core::Grid& grid, std::size_t axis, std::size_t nodes);

} // namespace wakesurf::importer
