// A line across the flow in a domain of any shape: where fluid enters, along the inlet as it is shaped rather than
// along the domain's box.
#pragma once

#include "core/surface/suggestion/flow_survey.hpp"

#include <optional>

namespace wakesurf::core {

/// A line, all of it in fluid.
struct FluidLine {
    std::array<Vec3, 2> line{};
    Vec3 sweep{0.0};     ///< from its middle, in fluid, across it and the flow
    bool enters = false; ///< fluid enters there; else it is where the flow is fastest
};

/// Returns the line that sweeps most, through one of the places where most comes in, or else where the fluid is
/// fastest; at rest the longest. Nothing if the survey met no fluid.
/// @param longest  length of the line
/// @param sweep    at most so long, as a part of the line
/// Cost: some 40,000 lookups.
std::optional<FluidLine>
find_line(const Flow& flow, const FlowSurvey& survey, double longest, double sweep);

} // namespace wakesurf::core
