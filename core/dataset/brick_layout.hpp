// Cuts the nodes of a uniform or a rectilinear grid into bricks, the pieces in which a time-step that is
// larger than memory is stored, read and kept: each has 32 cells an axis and all their nodes, so that a
// cell's eight nodes are in one brick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

/// Bricks have numbers, x fastest. On the disk they lie in Morton order, where neighbours are near each
/// other. All bricks of a grid are of one size: where the grid ends within one, the nodes beyond repeat the
/// last ones.
class BrickLayout {
  public:
    /// This size measured best: bricks of 16 halve the bytes, but take five times the reads and three times
    /// the rounds of them.
    static constexpr std::uint32_t usual_cells = 32;

    /// @param dimensions  nodes an axis of the grid, at least 2
    /// @param cells       an axis of a brick, a power of two
    explicit BrickLayout(const std::array<std::uint32_t, 3>& dimensions,
                         std::uint32_t cells = usual_cells);

    /// Returns the grid's nodes an axis.
    const std::array<std::uint32_t, 3>& dimensions() const { return dimensions_; }

    /// Returns a brick's cells an axis.
    std::uint32_t cells() const { return std::uint32_t{1} << shift_; }

    /// Returns the base-2 logarithm of cells().
    std::uint32_t shift() const { return shift_; }

    /// Returns the number of bricks an axis.
    const std::array<std::uint32_t, 3>& bricks() const { return bricks_; }

    /// Returns the number of all bricks.
    std::size_t count() const { return std::size_t{bricks_[0]} * bricks_[1] * bricks_[2]; }

    /// Returns the nodes an axis of each brick: one more than cells, or all of a thinner grid's.
    const std::array<std::uint32_t, 3>& brick_nodes() const { return brick_nodes_; }

    /// Returns the number of a brick's nodes, which are stored x fastest.
    std::size_t nodes_per_brick() const {
        return std::size_t{brick_nodes_[0]} * brick_nodes_[1] * brick_nodes_[2];
    }

    /// The brick that has a cell.
    std::size_t brick_of(const std::array<std::size_t, 3>& cell) const {
        return (cell[0] >> shift_) +
               bricks_[0] * ((cell[1] >> shift_) + bricks_[1] * (cell[2] >> shift_));
    }

    /// A node in one of the bricks that have it.
    struct BrickNode {
        std::size_t brick; ///< its number
        std::size_t node;  ///< in the brick, x fastest
    };

    /// @param node  of the grid, x fastest
    BrickNode place_of(std::size_t node) const {
        return place_of({node % dimensions_[0], node / dimensions_[0] % dimensions_[1],
                         node / dimensions_[0] / dimensions_[1]});
    }

    /// @param node  of the grid, by its place on each axis
    BrickNode place_of(const std::array<std::size_t, 3>& node) const {
        std::array<std::size_t, 3> cell, within;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            cell[axis] = std::min<std::size_t>(node[axis], dimensions_[axis] - 2);
            within[axis] = node[axis] - (cell[axis] >> shift_ << shift_);
        }
        return {brick_of(cell),
                within[0] + brick_nodes_[0] * (within[1] + brick_nodes_[1] * within[2])};
    }

    /// The brick that has several nodes of one cell, and where each is in it. @param places  as many as nodes
    std::size_t places_of(std::span<const std::size_t> nodes, std::span<std::size_t> places) const;

    /// The grid's node that is a brick's lowest.
    std::array<std::size_t, 3> first_node(std::size_t brick) const;

    /// Returns the brick's place in the order of the disk. Counts whole blocks of bricks, down to one: no
    /// table of all bricks, which metadata alone could make as large as they like.
    std::size_t place_on_disk(std::size_t brick) const;

    /// Returns the brick that lies at a place of the disk. REQUIRES: there are more bricks than that.
    std::size_t brick_on_disk(std::size_t place) const;

  private:
    template <class Chosen>
    std::size_t descend(Chosen&& chosen) const;

    std::array<std::uint32_t, 3> dimensions_;
    std::array<std::uint32_t, 3> bricks_;
    std::array<std::uint32_t, 3> brick_nodes_;
    std::uint32_t shift_;
};

} // namespace wakesurf::core
