// What the viewer of an animation says of it: AnimationDescription of web-client/src/animation/animationFile.ts.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "server/live/surface_animation.hpp"
#include "server/live/surface_job.hpp"

#include <string>

namespace wakesurf::server {

/// Returns the description as JSON. Errors are those of the last step's statistics.
std::string description_of(const SurfaceAnimation& animation,
                           const SurfaceJob& job,
                           const core::DatasetInfo& dataset,
                           const std::string& version);

} // namespace wakesurf::server
