// Blocks of residuals as bytes: what stands out as escapes, the rest by Draco. protocol/wire/README.md, Points.
// Twin: web-client/src/protocol/wirePoints.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Residuals begin .. end - 1, at least one, as a block. Error: what encode_points reports.
core::Result<Bytes> write_block(const Residuals& residuals, std::uint32_t begin, std::uint32_t end);

/// Reads a block and moves `at` behind it.
/// @param attributes  of the mesh
/// @param most        vertices the block may have
/// Error: Corrupt. Never reads outside `bytes`, and allocates for `most` vertices at most.
core::Result<Residuals> read_block(std::span<const std::byte> bytes,
                                   std::size_t& at,
                                   std::uint8_t attributes,
                                   std::uint32_t most);

} // namespace wakesurf::protocol
