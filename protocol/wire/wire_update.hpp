// An update as frames: its numbers, then Draco's bytes of its points, cut if they are long. Blocks of points
// are encoded in parallel.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Writes an update. Error: OverLimit, and as write_block.
/// @param header   of the update; members that differ between frames are filled in
/// @param numbers  the ranges of a KEY, and the topology
/// @param points   in their order on the wire; may be empty
core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::vector<std::uint32_t> numbers,
                                        std::span<const Residuals> points);

} // namespace wakesurf::protocol
