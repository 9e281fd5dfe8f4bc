// Blocks of residuals as bytes: outliers as escapes, the rest by Draco. protocol/wire/FORMAT.md, Points.
// Twin: web-client/src/protocol/wirePoints.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/numbers.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Holds a block: its numbers, and Draco's bytes for most residuals, empty if none is left for it.
struct PointBlock {
    std::vector<std::uint32_t> numbers;
    Bytes draco;
};

/// Writes the residuals begin .. end - 1, at least one and at most max_block_vertices. Error: as
/// encode_points.
core::Result<PointBlock>
write_block(const Residuals& residuals, std::uint32_t begin, std::uint32_t end);

/// Describes the block to read.
struct BlockPlace {
    PointKind kind = PointKind::Moved;
    std::uint8_t attributes = 0; ///< of the mesh
    std::uint32_t most = 0;      ///< vertices it may have
};

/// Reads a block; `draco` is then the blocks behind it. Error: Corrupt. Allocates for `most` vertices at
/// most.
core::Result<Residuals>
read_block(Numbers& numbers, std::span<const std::byte>& draco, const BlockPlace& place);

} // namespace wakesurf::protocol
