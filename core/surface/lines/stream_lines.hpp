// Streamlines of the field at one time, from any seeds, with the values of a field along them. Their curves are those that stream surfaces
// are made of: the same steps of controlled error, walls and places at rest.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/field/flow.hpp"
#include "core/field/sampled_field.hpp"
#include "core/surface/lines/traced_lines.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstddef>
#include <span>
#include <stop_token>

namespace wakesurf::core {

struct StreamLinesRequest {
    Direction direction = Direction::Both;
    SampledField field = SpeedField{};
    double time = 0.0;     ///< of no meaning in a flow that stands still
    double duration = 0.0; ///< time of flight each way; 0: as long as it takes
    double length = 0.0;   ///< arc length each way; 0: lengths_in_domain of the domain's diagonal
    std::size_t most_points = 1'000'000; ///< of all lines; the longest are cut
};

/// A line that goes round for ever ends after so many diagonals of the domain.
inline constexpr double lengths_in_domain = 2.0;

/// Two points of a line are at most so far apart: a part of the domain's diagonal.
inline constexpr double gaps_in_domain = 250.0;

/// Traces them. Two points of a line are at most a 250th of the domain's diagonal apart, and lie as close as a turn of 3 degrees needs.
/// Runs in parallel; the bytes do not depend on the number of threads.
/// @param memory  is asked before it is taken. Error: OutOfTime, Cancelled, OverLimit, what reading reports.
Result<StreamLines> trace_stream_lines(const StreamLinesRequest& request,
                                       const Flow& flow,
                                       std::span<const Vec3> seeds,
                                       WorkMemory& memory,
                                       const std::stop_token& stop);

} // namespace wakesurf::core
