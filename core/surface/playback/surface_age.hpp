// Where a surface is at a time of a clock: its age, from the (first) release to its end.
#pragma once

#include "core/surface/surface_parameters.hpp"

#include <optional>

namespace wakesurf::core {

/// Says whether it looks different at different times of a clock.
bool moves(const SurfaceParameters& parameters);

/// Returns its age at a time of the clock, clamped to the times of the surface; at its end without a time.
double age_at(const SurfaceParameters& parameters, std::optional<double> time);

} // namespace wakesurf::core
