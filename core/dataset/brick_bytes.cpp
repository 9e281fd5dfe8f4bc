#include "core/dataset/brick_bytes.hpp"

#include <algorithm>

namespace wakesurf::core {

BrickBytes::BrickBytes(const BrickLayout& layout) : layout_(layout), at_(layout.count(), same(0)) {}

void BrickBytes::set(std::size_t brick, std::span<const std::uint8_t> nodes) {
    if (std::all_of(nodes.begin(), nodes.end(), [&](auto value) { return value == nodes[0]; })) {
        set(brick, nodes[0]);
        return;
    }
    auto& own = own_[brick];
    own.assign(nodes.begin(), nodes.end());
    at_[brick] = own.data();
}

std::optional<std::uint8_t> BrickBytes::only_value(std::size_t brick) const {
    for (const auto& [value, nodes] : same_)
        if (nodes.data() == at_[brick])
            return value;
    return std::nullopt;
}

std::size_t BrickBytes::bytes() const {
    return at_.size() * sizeof(at_[0]) + (same_.size() + own_.size()) * layout_.nodes_per_brick();
}

const std::uint8_t* BrickBytes::same(std::uint8_t value) {
    auto& nodes = same_[value];
    nodes.resize(layout_.nodes_per_brick(), value);
    return nodes.data();
}

} // namespace wakesurf::core
