// An update as frames: its numbers, then what Draco makes of its points, cut where that is long. Blocks of points are encoded in
// parallel.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// @param header   of the update; what differs from frame to frame is filled in
/// @param numbers  the ranges of a KEY, and the topology
/// @param points   in their order on the wire; may be empty
/// Error: OverLimit, and what write_block reports.
core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::vector<std::uint32_t> numbers,
                                        std::span<const Residuals> points);

} // namespace wakesurf::protocol
