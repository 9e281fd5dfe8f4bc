// What the viewer of an animation says of it.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "protocol/files/animation_page.hpp"
#include "server/live/surface_animation.hpp"
#include "server/live/surface_job.hpp"

#include <string>

namespace wakesurf::server {

/// Returns the description, without a look. Errors are those of the last step's statistics.
protocol::AnimationDescription description_of(const SurfaceAnimation& animation,
                                              const SurfaceJob& job,
                                              const core::DatasetInfo& dataset,
                                              const std::string& version);

} // namespace wakesurf::server
