// The plan of an early pass: the same surface, coarser, so that there is something to see at once.
#pragma once

#include "core/surface/request/surface_plan.hpp"
#include "server/live/surface_pass.hpp"

namespace wakesurf::server {

/// Returns the plan of an early pass. The engine's quad budget bounds the work for any separation. A path
/// surface is built whole, for any time of the pass; the others end at that time. REQUIRES: the pass is
/// coarse or refined.
core::SurfacePlan early_plan(core::SurfacePlan plan, const SurfacePass& pass);

} // namespace wakesurf::server
