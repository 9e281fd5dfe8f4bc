// Finds what stands in the flow: parts of the domain without fluid, and walls, that the flow goes round
// rather than along.
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

} // namespace wakesurf::core
