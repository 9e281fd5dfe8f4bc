// Surfaces as they were kept before API level 5, when `backward` went back from `from` whether `to` was
// earlier or later: today's readers refuse a later `to`, so it can mean nothing else, and is converted.
#pragma once

#include "core/surface/surface_parameters.hpp"

namespace wakesurf::server {

/// Returns the same surface as it is written today; with its direction, which very old records lack.
core::SurfaceParameters from_older(core::SurfaceParameters parameters);

} // namespace wakesurf::server
