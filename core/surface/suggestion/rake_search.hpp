// Where a suggested rake may lie: the body in the flow that is most worth showing, and without one a line
// across the flow, along the inlet as it is shaped rather than along the domain's box.
#pragma once

#include "core/dataset/wall_geometry.hpp"
#include "core/surface/suggestion/flow_survey.hpp"

#include <optional>

namespace wakesurf::core {

/// Returns the box round the most interesting body: of the largest across the flow, the one that the flow
/// meets first. A body that reaches the side where the flow enters or leaves is the edge of the domain, as
/// the wall of a channel. A body thinner than some hundredth of the domain is found if `walls` have it, or if
/// the flow knows that there is an obstacle. REQUIRES: survey.through(). Cost: at most some 2 million
/// lookups, and a pass over the walls' triangles.
std::optional<Box> find_body(const Flow& flow, const FlowSurvey& survey, const WallGeometry& walls);

/// A line, all of it in fluid.
struct FluidLine {
    std::array<Vec3, 2> line{};
    Vec3 sweep{0.0};     ///< from its middle, in fluid, across it and the flow
    bool enters = false; ///< fluid enters there; else it is where the flow is fastest
};

/// Returns the line that sweeps most, through one of the places where most comes in, or else where the
/// fluid is fastest; at rest the longest. Nothing if the survey met no fluid.
/// @param longest  length of the line
/// @param sweep    at most so long, as a part of the line
/// Cost: some 40,000 lookups.
std::optional<FluidLine>
find_line(const Flow& flow, const FlowSurvey& survey, double longest, double sweep);

} // namespace wakesurf::core
