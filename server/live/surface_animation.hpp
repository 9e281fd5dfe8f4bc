// A surface's evolution as the frames of its steps, as the wire sends them while a surface plays.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/surface.hpp"
#include "server/live/announced_ranges.hpp"
#include "server/live/surface_job.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct SurfaceAnimation {
    std::string frames;             ///< each preceded by its length as u32
    std::vector<double> times;      ///< of the steps
    ValueRanges ranges;             ///< over all steps
    core::Surface last;             ///< the surface at the last time
    std::size_t most_vertices = 0;  ///< of a step
    std::uint64_t all_vertices = 0; ///< of all steps together
};

/// Builds and encodes the steps, with protocol::live_tolerance.
/// @param times  between `from` and `to`, in the order in which the surface moves; of a stream surface `from`
///               plus the age
/// Error: Cancelled, as Evolution, sampling the fields and MeshStream.
core::Result<SurfaceAnimation> animate(const SurfaceJob& job,
                                       std::span<const double> times,
                                       const core::Clock& clock,
                                       const std::stop_token& stop,
                                       const core::WorkPart& work = {});

} // namespace wakesurf::server
