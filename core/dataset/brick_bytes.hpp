// A byte for each node of a grid in bricks, of which most hold one value only: those share its bytes, so that
// the walls of a large grid take the memory of the bricks through which they go. Beside brick_table.hpp,
// which holds what is read when it is needed.
#pragma once

#include "core/dataset/brick_layout.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Costs a pointer a brick, and the bytes of bricks with several values. Thread safety: of any const object.
class BrickBytes {
  public:
    /// Makes a grid of zeros.
    explicit BrickBytes(const BrickLayout& layout);
    /// Moving keeps the pointers that at() returned valid.
    BrickBytes(BrickBytes&&) = default;

    /// Moving keeps the pointers that at() returned valid.
    BrickBytes& operator=(BrickBytes&&) = default;

    /// Returns how the grid is cut into bricks.
    const BrickLayout& layout() const { return layout_; }

    /// Replaces a brick's bytes. REQUIRES: as many as it has nodes, x fastest.
    void set(std::size_t brick, std::span<const std::uint8_t> nodes);

    /// Replaces them by one value.
    void set(std::size_t brick, std::uint8_t value) { at_[brick] = same(value); }

    /// Returns a brick's bytes, x fastest.
    const std::uint8_t* at(std::size_t brick) const { return at_[brick]; }

    /// The value of all of a brick's nodes; none where they have several.
    std::optional<std::uint8_t> only_value(std::size_t brick) const;

    /// Returns the byte of a node by its index on each axis; for a cell, give the lowest node's.
    std::uint8_t of(const std::array<std::size_t, 3>& node) const {
        const auto place = layout_.place_of(node);
        return at_[place.brick][place.node];
    }

    /// Returns the bytes by brick, as the batch kernel takes them.
    const std::uint8_t* const* pointers() const { return at_.data(); }

    /// Returns the bytes of memory that it takes.
    std::size_t bytes() const;

  private:
    const std::uint8_t* same(std::uint8_t value);

    BrickLayout layout_;
    std::map<std::uint8_t, std::vector<std::uint8_t>> same_; ///< a whole brick's, by value
    std::map<std::size_t, std::vector<std::uint8_t>> own_;   ///< by brick
    std::vector<const std::uint8_t*> at_;
};

} // namespace wakesurf::core
