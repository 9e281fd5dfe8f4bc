#include "core/dataset/brick_layout.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace wakesurf::core {

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

/// Goes down from all bricks to one by the block of each size that has it, of the eight that halve the one
/// before. Returns the number of bricks in the blocks before those.
/// @param chosen  `chosen(block, size, before, count)`: whether it is in the block of `count` bricks that
///                begins at the brick `block` on each axis, if it is in none of those before
template <class Chosen>
std::size_t BrickLayout::descend(Chosen&& chosen) const {
    using Block = std::array<std::size_t, 3>;
    Block at{};
    std::size_t before = 0;
    const auto longest = *std::max_element(bricks_.begin(), bricks_.end());
    for (int level = std::bit_width(longest - 1) - 1; level >= 0; --level) {
        const std::size_t size = std::size_t{1} << level;
        Block block{};
        for (std::size_t which = 0; which < 8; ++which) {
            std::size_t count = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block[axis] = at[axis] + (which >> axis & 1) * size;
                count *= std::min(size, bricks_[axis] -
                                            std::min<std::size_t>(bricks_[axis], block[axis]));
            }
            if (chosen(block, size, before, count))
                break;
            before += count;
        }
        at = block;
    }
    return before;
}

std::size_t BrickLayout::place_on_disk(std::size_t brick) const {
    const std::array<std::size_t, 3> wanted{brick % bricks_[0], brick / bricks_[0] % bricks_[1],
                                            brick / bricks_[0] / bricks_[1]};
    return descend([&](const auto& block, std::size_t size, std::size_t, std::size_t) {
        return wanted[0] < block[0] + size && wanted[1] < block[1] + size &&
               wanted[2] < block[2] + size;
    });
}

std::size_t BrickLayout::brick_on_disk(std::size_t place) const {
    std::array<std::size_t, 3> at{};
    descend([&](const auto& block, std::size_t, std::size_t before, std::size_t count) {
        at = block;
        return place < before + count;
    });
    return at[0] + bricks_[0] * (at[1] + bricks_[1] * at[2]);
}

} // namespace wakesurf::core
