// A streak or time surface from its plan to its mesh at `to`: the moving surface run to its end.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <stop_token>

namespace wakesurf::core {

/// Builds a streak or time surface for build_surface.
Result<Surface> build_moving_surface(const SurfacePlan& plan,
                                     std::stop_token stop,
                                     const Clock& clock,
                                     const WorkPart& work = {});

} // namespace wakesurf::core
