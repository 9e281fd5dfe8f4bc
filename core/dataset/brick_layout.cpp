#include "core/dataset/brick_layout.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>

namespace wakesurf::core {

namespace {

/// Puts two zero bits after each of the low 21 bits.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x001f00000000ffffull;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffull;
    bits = (bits | bits << 8) & 0x100f00f00f00f00full;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
    return (bits | bits << 2) & 0x1249249249249249ull;
}

} // namespace

BrickLayout::BrickLayout(const std::array<std::uint32_t, 3>& dimensions, std::uint32_t cells)
    : dimensions_(dimensions), shift_(static_cast<std::uint32_t>(std::countr_zero(cells))) {
    if (!std::has_single_bit(cells))
        throw std::invalid_argument("the cells of a brick's axis are no power of two");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (dimensions[axis] < 2)
            throw std::invalid_argument("a grid in bricks has at least two nodes an axis");
        bricks_[axis] = ((dimensions[axis] - 2) >> shift_) + 1;
        brick_nodes_[axis] = std::min(dimensions[axis], cells + 1);
    }
}

std::size_t BrickLayout::places_of(std::span<const std::size_t> nodes,
                                   std::span<std::size_t> places) const {
    const auto place = [&](const std::array<std::size_t, 3>& at) {
        return at[0] + brick_nodes_[0] * (at[1] + brick_nodes_[1] * at[2]);
    };
    std::array<std::size_t, 3> cell{dimensions_[0] - 2, dimensions_[1] - 2, dimensions_[2] - 2};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::size_t row = nodes[i] / dimensions_[0];
        const std::array<std::size_t, 3> at{nodes[i] % dimensions_[0], row % dimensions_[1],
                                            row / dimensions_[1]};
        places[i] = place(at);
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = std::min(cell[axis], at[axis]);
    }
    const auto first = [&](std::size_t axis) { return cell[axis] >> shift_ << shift_; };
    const std::size_t corner = place({first(0), first(1), first(2)});
    for (std::size_t i = 0; i < nodes.size(); ++i)
        places[i] -= corner;
    return brick_of(cell);
}

std::array<std::size_t, 3> BrickLayout::first_node(std::size_t brick) const {
    return {brick % bricks_[0] << shift_, brick / bricks_[0] % bricks_[1] << shift_,
            brick / bricks_[0] / bricks_[1] << shift_};
}

std::vector<std::uint32_t> BrickLayout::morton_order() const {
    std::vector<std::uint64_t> code(count());
    for (std::size_t brick = 0; brick < code.size(); ++brick) {
        const auto first = first_node(brick);
        code[brick] = spread(first[0] >> shift_) | spread(first[1] >> shift_) << 1 |
                      spread(first[2] >> shift_) << 2;
    }
    std::vector<std::uint32_t> order(code.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return code[a] < code[b]; });
    return order;
}

} // namespace wakesurf::core
