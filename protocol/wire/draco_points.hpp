// Residuals as a Draco sequential point cloud, the only Draco encoding that keeps their order. The only file
// of the wire that knows Draco. protocol/wire/FORMAT.md, Draco block. Twin:
// web-client/src/protocol/dracoPoints.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Holds the numbers of one Draco attribute, `components` for each point.
template <class T>
struct Channel {
    std::span<T> values;
    std::size_t components = 1;
};

/// Encodes residuals. REQUIRES: as many points in each channel, at least one point and one channel; no value
/// of 2^17 or more, which would cost Draco a table of that size. Error: OverLimit or Corrupt if Draco refuses
/// or throws.
core::Result<Bytes> encode_points(std::span<const Channel<const std::int32_t>> channels,
                                  std::uint32_t points);

/// Fills the channels, whose lengths are as expected. Error: Corrupt. Draco trusts the counts in its own
/// header, so these are compared first.
core::Result<void> decode_points(std::span<const std::byte> draco,
                                 std::span<const Channel<std::int32_t>> channels,
                                 std::uint32_t points);

} // namespace wakesurf::protocol
