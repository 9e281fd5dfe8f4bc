// Limiting streamlines: lines that lie on a wall and follow the flow just beside it, as oil does that is painted on. They end where the flow
// leaves the wall or comes to it, where it rests, and at the wall's border.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "core/surface/lines/wall_web.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Traces them on the triangles of the wall, in which the velocity beside it is linear; only what of it lies in the wall counts.
/// Vertices at one place are one, and an edge of more than two triangles is a border. `field` and `time` of the request are of no meaning;
/// `length` is needed. The bytes do not depend on the number of threads. @param gap  between points of a line
/// @param memory  is asked before it is taken. Error: Cancelled, OverLimit.
Result<StreamLines> trace_wall_lines(const StreamLinesRequest& request,
                                     const WallFlow& flow,
                                     std::span<const WallPlace> seeds,
                                     double gap,
                                     WorkMemory& memory,
                                     const std::stop_token& stop);

} // namespace wakesurf::core
