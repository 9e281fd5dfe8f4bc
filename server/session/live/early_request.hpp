// What an early pass of a surface asks the engine for: the same surface, coarser, so that there is something to see at once.
#pragma once

#include "server/session/live/surface_job.hpp"
#include "server/session/live/surface_pass.hpp"

namespace wakesurf::server {

struct EarlyRequest {
    core::Rake rake;
    core::SurfaceParameters parameters;
};

/// The engine's quad budget bounds the work whatever the separation asked for. Of a path surface all of it, whatever the pass's time; the
/// others end at that time.
/// REQUIRES: the pass is coarse or refined.
EarlyRequest early_request(const SurfaceJob& job, const SurfacePass& pass);

} // namespace wakesurf::server
