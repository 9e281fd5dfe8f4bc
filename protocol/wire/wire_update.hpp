// An update as frames: its topology, cut where it is long, then its blocks of points. Blocks are encoded in parallel.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace wakesurf::protocol {

using SharedFrames = std::vector<std::shared_ptr<const std::vector<std::byte>>>;

/// @param header  of the update; what differs from frame to frame is filled in
/// @param ranges  of a KEY
/// @param points  in their order on the wire; may be empty
/// Error: OverLimit, and what write_block reports.
core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::span<const AttributeRange> ranges,
                                        std::span<const std::byte> topology,
                                        std::span<const Residuals> points);

} // namespace wakesurf::protocol
