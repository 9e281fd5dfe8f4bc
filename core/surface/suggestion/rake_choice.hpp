// Where to put a first rake: ahead of the body that the flow meets, else where the flow turns, else where it
// enters.
#pragma once

#include "core/dataset/wall_geometry.hpp"
#include "core/surface/suggestion/flow_survey.hpp"

#include <optional>
#include <string>

namespace wakesurf::core {

struct RakeChoice {
    std::array<Vec3, 2> line{};
    Vec3 sweep{0.0};           ///< for a time surface's patch
    double speed = 0.0;        ///< with which particles leave, about; 0: the flow is at rest
    double way = 0.0;          ///< that they go until they leave the domain, about
    std::optional<Box> body{}; ///< which the rake stands ahead of
    std::string why;           ///< in words that go on after "The rake is"
};

/// @param walls   of the flow, as far as they are known
/// @param time    that particles can be followed for, at most; nothing: as long as one likes
RakeChoice choose_rake(const Flow& flow,
                       const FlowSurvey& survey,
                       const WallGeometry& walls,
                       std::optional<double> time);

} // namespace wakesurf::core
