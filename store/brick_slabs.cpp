#include "store/brick_slabs.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace wakesurf::store {

BrickSlabs::BrickSlabs(const core::BrickLayout& layout, std::size_t node_bytes, Put put)
    : layout_(layout), node_bytes_(node_bytes), put_(std::move(put)),
      slab_(layer_bytes() * layout.brick_nodes()[2]),
      brick_(layout.nodes_per_brick() * node_bytes) {}

std::size_t BrickSlabs::layer_bytes() const {
    return std::size_t{layout_.dimensions()[0]} * layout_.dimensions()[1] * node_bytes_;
}

core::Result<void> BrickSlabs::add(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        if (complete())
            throw std::logic_error("a grid was given more nodes than it has");
        const std::size_t below = std::size_t{layer_} << layout_.shift();
        const std::size_t layers =
            std::min<std::size_t>(layout_.brick_nodes()[2], layout_.dimensions()[2] - below);
        const std::size_t count = std::min(bytes.size(), layers * layer_bytes() - filled_);
        std::memcpy(slab_.data() + filled_, bytes.data(), count);
        filled_ += count;
        bytes = bytes.subspan(count);
        if (filled_ < layers * layer_bytes())
            return {};
        if (auto put = put_layer(); !put)
            return put;
        // The next layer of bricks begins with the nodes that this one ends with.
        std::memmove(slab_.data(), slab_.data() + filled_ - layer_bytes(), layer_bytes());
        filled_ = layer_bytes();
        ++layer_;
    }
    return {};
}

core::Result<void> BrickSlabs::put_layer() {
    const std::size_t count = std::size_t{layout_.bricks()[0]} * layout_.bricks()[1];
    std::vector<std::pair<std::size_t, std::size_t>> bricks(count); // place, number
    for (std::size_t i = 0; i < count; ++i)
        bricks[i] = {layout_.place_on_disk(count * layer_ + i), count * layer_ + i};
    std::sort(bricks.begin(), bricks.end());
    const std::size_t below = (std::size_t{layer_} << layout_.shift()) * layout_.dimensions()[0] *
                              layout_.dimensions()[1];
    const std::size_t row = layout_.brick_nodes()[0];
    for (const auto& [place, brick] : bricks) {
        for_rows_of(layout_, brick, [&](std::size_t to, std::size_t from, std::size_t nodes) {
            auto* const out = brick_.data() + to * node_bytes_;
            std::memcpy(out, slab_.data() + (from - below) * node_bytes_, nodes * node_bytes_);
            for (std::size_t i = nodes; i < row; ++i)
                std::memcpy(out + i * node_bytes_, out + (nodes - 1) * node_bytes_, node_bytes_);
        });
        if (auto put = put_(place, brick_); !put)
            return put;
    }
    return {};
}

} // namespace wakesurf::store
