// mask.u8 of a store in bricks: a byte a brick in the order of the file, 0 solid, 1 fluid, 2 mixed, then the
// bytes of the nodes of each mixed brick in that order. Most bricks of most grids are not mixed.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/dataset/brick_bytes.hpp"
#include "store/store_layout.hpp"
#include "store/store_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace wakesurf::store {

/// The next nodes' bytes, 1 fluid, 0 solid, x fastest, valid until the next call; none at the end.
using NextMask = std::function<core::Result<std::span<const std::uint8_t>>()>;

/// Writes the mask of a grid, in bricks or a byte a node, as the layout says; returns the file's CRC-32C.
/// Memory in bricks: those that are mixed, and as BrickSlabs. Error: Io, or what `next` reports.
core::Result<std::uint32_t>
write_mask(StoreWriter& writer, const StoreLayout& layout, const NextMask& next);

/// Returns the nodes' bytes, 1 fluid, 0 solid. Error: Corrupt for a size, a state or a node that cannot be;
/// to be read after the file's name.
core::Result<core::BrickBytes> parse_brick_mask(std::span<const std::byte> bytes,
                                                const core::BrickLayout& layout);

/// Reads the file of a store in bricks. Error: that of read_fixed_file and parse_brick_mask.
core::Result<core::BrickBytes> read_brick_mask(const StoreLayout& layout, const core::Disk& disk);

} // namespace wakesurf::store
