// A streak or time surface that goes both ways in time is two surfaces that share its budget; any other is one.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/surface_parameters.hpp"

#include <vector>

namespace wakesurf::core {

struct MovingPart {
    SurfaceParameters parameters; ///< of one direction, with a separation
    double sign;                  ///< of its time: 1, or -1 backward

    bool backward() const { return sign < 0.0; }
};

/// Forward first. Error: OutOfTime where the flow does not reach as far.
Result<std::vector<MovingPart>> moving_parts(const Flow& flow, const SurfaceParameters& parameters);

} // namespace wakesurf::core
