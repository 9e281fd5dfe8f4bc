// The points of one frame as a Draco sequential point cloud, the only Draco encoding that keeps their order. Values are
// differences of consecutive points, each of which Draco predicts from the one before. The only file that knows Draco.
// Twin: web-client/src/protocol/dracoPoints.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/bytes.hpp"
#include "protocol/lattice.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// The attribute spans are as long as `positions`, which is not empty.
/// Error: OverLimit or Corrupt when Draco refuses or throws.
core::Result<Bytes> encode_points(std::span<const LatticePoint> positions,
                                  std::span<const std::span<const std::uint16_t>> attributes);

/// Fills the spans, whose lengths are the expected number of points, at least 1.
/// Error: Corrupt. Draco trusts the counts in its own header, so these are compared first.
core::Result<void> decode_points(std::span<const std::byte> draco,
                                 std::span<LatticePoint> positions,
                                 std::span<const std::span<std::uint16_t>> attributes);

} // namespace wakesurf::protocol
