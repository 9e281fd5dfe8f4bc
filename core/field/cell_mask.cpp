#include "core/field/cell_mask.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

using Nodes = std::array<std::uint32_t, 3>;

/// Writes the State of each cell of a block of nodes to its lowest node.
void find_states(const Nodes& nodes, const std::uint8_t* fluid, std::uint8_t* state) {
    const std::size_t row = nodes[0];
    const std::size_t slice = row * nodes[1];
    for (std::uint32_t z = 0; z + 1 < nodes[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < nodes[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < nodes[0]; ++x) {
                const std::size_t node = z * slice + y * row + x;
                int count = 0;
                for (const std::size_t corner :
                     {node, node + row, node + slice, node + slice + row})
                    count += (fluid[corner] != 0) + (fluid[corner + 1] != 0);
                state[node] = count == 8   ? CellMask::Fluid
                              : count == 0 ? CellMask::Solid
                                           : CellMask::Mixed;
            }
}

BrickBytes states_in(const BrickBytes& fluid) {
    const BrickLayout& layout = fluid.layout();
    BrickBytes states(layout); // Fluid
    std::vector<std::uint8_t> own(layout.nodes_per_brick());
    for (std::size_t brick = 0; brick < layout.count(); ++brick)
        if (const auto value = fluid.only_value(brick)) {
            states.set(brick, *value != 0 ? CellMask::Fluid : CellMask::Solid);
        } else {
            std::fill(own.begin(), own.end(), CellMask::Fluid);
            find_states(layout.brick_nodes(), fluid.at(brick), own.data());
            states.set(brick, own);
        }
    return states;
}

/// Raises each State to the highest from one node before it to two after it, on each axis.
void spread(const Nodes& nodes, std::vector<std::uint8_t>& state) {
    std::size_t stride = 1;
    std::vector<std::uint8_t> line;
    for (const std::uint32_t count : nodes) {
        line.resize(count);
        for (std::size_t first = 0; first < state.size(); ++first) {
            if (first / stride % count != 0)
                continue;
            for (std::size_t i = 0; i < count; ++i)
                line[i] = state[first + i * stride];
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = i - std::min<std::size_t>(i, 1);
                     k <= std::min<std::size_t>(i + 2, count - 1); ++k)
                    state[first + i * stride] = std::max(state[first + i * stride], line[k]);
        }
        stride *= count;
    }
}

/// Visits bricks one by one, each with the nodes round it, of which a grid has none beyond its end.
class RoundBricks {
  public:
    explicit RoundBricks(const BrickBytes& fluid) : fluid_(fluid), layout_(fluid.layout()) {}

    BrickBytes all() {
        BrickBytes round(layout_); // Fluid
        for (std::size_t brick = 0; brick < layout_.count(); ++brick) {
            const auto value = fluid_.only_value(brick);
            if (value && *value == 0)
                round.set(brick, CellMask::Mixed);
            else if (!value || !fluid_round(brick))
                round.set(brick, states_of(brick));
        }
        return round;
    }

  private:
    /// The bricks round it hold fluid only.
    bool fluid_round(std::size_t brick) const {
        std::array<std::size_t, 3> low, high;
        const auto first = layout_.first_node(brick);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t place = first[axis] >> layout_.shift();
            low[axis] = place - std::min<std::size_t>(place, 1);
            high[axis] = std::min<std::size_t>(place + 1, layout_.bricks()[axis] - 1);
        }
        const auto& bricks = layout_.bricks();
        for (std::size_t z = low[2]; z <= high[2]; ++z)
            for (std::size_t y = low[1]; y <= high[1]; ++y)
                for (std::size_t x = low[0]; x <= high[0]; ++x)
                    if (fluid_.only_value(x + bricks[0] * (y + bricks[1] * z)) != 1)
                        return false;
        return true;
    }

    std::span<const std::uint8_t> states_of(std::size_t brick) {
        const auto first = layout_.first_node(brick);
        const auto& nodes = layout_.brick_nodes();
        const Nodes with{nodes[0] + 2, nodes[1] + 2, nodes[2] + 2}; // one more at each end
        around_.assign(std::size_t{with[0]} * with[1] * with[2], CellMask::Fluid);
        std::size_t at = 0;
        for (std::size_t z = 0; z < with[2]; ++z)
            for (std::size_t y = 0; y < with[1]; ++y)
                for (std::size_t x = 0; x < with[0]; ++x, ++at)
                    if (solid({first[0] + x, first[1] + y, first[2] + z}))
                        around_[at] = CellMask::Mixed;
        spread(with, around_);
        own_.clear();
        for (std::size_t z = 1; z <= nodes[2]; ++z)
            for (std::size_t y = 1; y <= nodes[1]; ++y) {
                const auto row =
                    around_.begin() + static_cast<std::ptrdiff_t>(1 + with[0] * (y + with[1] * z));
                own_.insert(own_.end(), row, row + nodes[0]);
            }
        return own_;
    }

    /// @param after  the node after it on each axis
    bool solid(const std::array<std::size_t, 3>& after) const {
        std::array<std::size_t, 3> node;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (after[axis] == 0 || after[axis] > layout_.dimensions()[axis])
                return false;
            node[axis] = after[axis] - 1;
        }
        return fluid_.of(node) == 0;
    }

    const BrickBytes& fluid_;
    const BrickLayout& layout_;
    std::vector<std::uint8_t> around_;
    std::vector<std::uint8_t> own_;
};

} // namespace

CellMask::CellMask(const Nodes& dimensions, const SolidMask& mask) {
    if (mask.bricks != nullptr) {
        bricks_ = states_in(*mask.bricks);
    } else if (!mask.empty()) {
        whole_.assign(mask.fluid.size(), Fluid);
        find_states(dimensions, mask.fluid.data(), whole_.data());
    }
}

CellMask CellMask::round_cells(const Nodes& dimensions, const SolidMask& mask) {
    CellMask round;
    if (mask.bricks != nullptr) {
        round.bricks_ = RoundBricks(*mask.bricks).all();
    } else if (!mask.empty()) {
        round.whole_.resize(mask.fluid.size());
        std::transform(mask.fluid.begin(), mask.fluid.end(), round.whole_.begin(),
                       [](std::uint8_t fluid) { return fluid != 0 ? Fluid : Mixed; });
        spread(dimensions, round.whole_);
    }
    return round;
}

} // namespace wakesurf::core
