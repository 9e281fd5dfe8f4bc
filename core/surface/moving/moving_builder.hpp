// A streak or time surface from its parameters to its mesh at `to`: the moving surface run to its end.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_parameters.hpp"

#include <stop_token>

namespace wakesurf::core {

/// See build_surface.
Result<Surface> build_moving_surface(const Flow& flow,
                                     const Rake& rake,
                                     const SurfaceParameters& parameters,
                                     std::stop_token stop,
                                     const Clock& clock,
                                     const WorkPart& work = {});

} // namespace wakesurf::core
