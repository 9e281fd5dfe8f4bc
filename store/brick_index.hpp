// The index of the bricks of a field at a time-step, in files like velocity_000000.bricks: checksums of their
// values, and whether they have gaps.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::store {

/// Bricks are in the order of the file (BrickLayout::place_on_disk).
struct BrickIndex {
    std::vector<std::uint32_t> checksums; ///< CRC-32C of a brick's bytes
    std::vector<std::uint8_t> gaps;       ///< 1: some of its values are not finite; else 0

    explicit BrickIndex(std::size_t bricks) : checksums(bricks), gaps(bricks) {}

    /// Returns the bytes of the file: all checksums, then all gaps.
    static constexpr std::uint64_t bytes(std::uint64_t bricks) { return 5 * bricks; }

    bool any_gap() const;

    bool operator==(const BrickIndex&) const = default;
};

std::vector<std::byte> brick_index_bytes(const BrickIndex& index);

/// Parses the file. Error: Corrupt for another size, and a gap that is neither 0 nor 1; to be read after the
/// file's name.
core::Result<BrickIndex> parse_brick_index(std::span<const std::byte> bytes, std::size_t bricks);

} // namespace wakesurf::store
