// The time at which each vertex of a finished surface is where it is: what fields are sampled at.
#pragma once

#include "core/surface/surface.hpp"
#include "core/surface/surface_parameters.hpp"

#include <vector>

namespace wakesurf::core {

/// Returns one time a vertex: the frozen time of a stream surface, release plus t on a path surface, the time
/// a streak or time surface is shown at.
std::vector<double> vertex_times(const Surface& surface, const SurfaceParameters& parameters);

} // namespace wakesurf::core
