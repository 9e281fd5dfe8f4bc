// Streamlines of the field at one time, from any seeds, with the values of a field along them. Their curves are those that stream surfaces
// are made of: the same steps of controlled error, walls and places at rest.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/field/flow.hpp"
#include "core/field/sampled_field.hpp"
#include "core/surface/surface_parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

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

/// Why ends of lines are where they are; with both directions a line has two.
struct LineEnds {
    std::uint32_t limit = 0;  ///< `duration` or `length`
    std::uint32_t domain = 0; ///< the domain's border
    std::uint32_t wall = 0;
    std::uint32_t rest = 0; ///< the flow does not move there
    std::uint32_t cut = 0;  ///< it had as many points, or steps, as a line may have
};

struct StreamLines {
    std::vector<Vec3> points;  ///< of all lines, one after the other, downstream
    std::vector<float> times;  ///< of flight at each point, from the seed; negative upstream
    std::vector<float> values; ///< of the field there; NaN where it has none
    std::vector<std::uint32_t> offsets; ///< line i has the points from offsets[i] to offsets[i + 1]
    std::vector<std::uint32_t> seed;    ///< the number of its seed, a line
    std::uint32_t seeds = 0;            ///< all of them
    std::uint32_t outside = 0; ///< of them in bodies or outside of the domain: they have no line
    LineEnds ends;
    std::optional<std::array<float, 2>> range; ///< of the values; nothing where there is none

    std::size_t lines() const { return seed.size(); }
};

/// Traces them. Two points of a line are at most a 250th of the domain's diagonal apart, and lie as close as a turn of 3 degrees needs.
/// Runs in parallel; the bytes do not depend on the number of threads.
/// @param memory  is asked before it is taken. Error: OutOfTime, Cancelled, OverLimit, what reading reports.
Result<StreamLines> trace_stream_lines(const StreamLinesRequest& request,
                                       const Flow& flow,
                                       std::span<const Vec3> seeds,
                                       WorkMemory& memory,
                                       const std::stop_token& stop);

} // namespace wakesurf::core
