// What an early pass of a surface asks the engine for: the same surface, coarser, so that there is something to see at once.
#pragma once

#include "core/surface/request/surface_plan.hpp"
#include "server/service/live/surface_pass.hpp"

namespace wakesurf::server {

/// The engine's quad budget bounds the work whatever the separation asked for. Of a path surface all of it, whatever the pass's time; the
/// others end at that time.
/// REQUIRES: the pass is coarse or refined.
core::SurfacePlan early_plan(core::SurfacePlan plan, const SurfacePass& pass);

} // namespace wakesurf::server
