// What the solid mask makes of the cells of a grid.
#pragma once

#include "core/dataset/solid_mask.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// Per cell: are all, none or some of its nodes fluid? One byte read answers nearly every status question.
class CellMask {
  public:
    /// @param dimensions  nodes an axis of the uniform or rectilinear grid
    CellMask(const std::array<std::uint32_t, 3>& dimensions, const SolidMask& mask);

    enum State : std::uint8_t { Fluid, Mixed, Solid };

    State state(std::size_t first_node) const {
        return state_.empty() ? Fluid : static_cast<State>(state_[first_node]);
    }

    /// A State a byte, by the cell's lowest node; null where all is fluid.
    const std::uint8_t* data() const { return state_.empty() ? nullptr : state_.data(); }

    /// The same of the cell and those round it, 4^3 nodes: Fluid where all are, else Mixed.
    static CellMask round_cells(const std::array<std::uint32_t, 3>& dimensions,
                                const SolidMask& mask);

  private:
    CellMask() = default;

    std::vector<std::uint8_t> state_; ///< indexed by the cell's lowest node
};

} // namespace wakesurf::core
