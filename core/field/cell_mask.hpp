// The solid mask by cells of a grid.
#pragma once

#include "core/dataset/solid_mask.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::core {

/// States for each cell whether all, none or some of its nodes are fluid, so that one byte read answers
/// nearly every status question. It is in bricks if the mask is.
class CellMask {
  public:
    /// @param dimensions  nodes an axis of the uniform or rectilinear grid
    CellMask(const std::array<std::uint32_t, 3>& dimensions, const SolidMask& mask);

    enum State : std::uint8_t { Fluid, Mixed, Solid };

    /// @param cell        its place on each axis
    /// @param first_node  its lowest node, x fastest
    State state(const std::array<std::size_t, 3>& cell, std::size_t first_node) const {
        return static_cast<State>(bricks_          ? bricks_->of(cell)
                                  : whole_.empty() ? std::uint8_t{Fluid}
                                                   : whole_[first_node]);
    }

    /// A State a byte, by the cell's lowest node; null where all is fluid, or in bricks.
    const std::uint8_t* whole() const { return whole_.empty() ? nullptr : whole_.data(); }

    /// Returns the bytes by brick; null where all is fluid, or in one piece.
    const BrickBytes* bricks() const { return bricks_ ? &*bricks_ : nullptr; }

    /// Makes the mask of each cell and those round it, 4^3 nodes: Fluid where all are, else Mixed.
    static CellMask round_cells(const std::array<std::uint32_t, 3>& dimensions,
                                const SolidMask& mask);

  private:
    CellMask() = default;

    std::vector<std::uint8_t> whole_; ///< by the cell's lowest node
    std::optional<BrickBytes> bricks_;
};

} // namespace wakesurf::core
