// One call from a plan to its surface.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <stop_token>

namespace wakesurf::core {

/// Builds a surface of any kind. Runs in the calling thread's oneTBB arena.
///
/// @param work  told how far it is: of a streak or time surface the time, else mostly the part of the rake;
///              and what memory it takes, in the end that of the mesh
/// @return      the surface; the same bytes for any number of threads. Where a time-step in its way cannot be
/// read it ends at the last one before that can, and its statistics say why; that costs building it twice.
/// Error: OverLimit (also where there is no memory), Cancelled within 50 ms of `stop`, and what loading a
/// time-step reports. Thread safety: concurrent calls are fine.
Result<Surface> build_surface(const SurfacePlan& plan,
                              std::stop_token stop = {},
                              const Clock& clock = SteadyClock{},
                              WorkPart work = {});

/// Plans it first. Error: as above, and as plan_surface.
Result<Surface> build_surface(const Flow& flow,
                              const Rake& rake,
                              const SurfaceParameters& parameters,
                              std::stop_token stop = {},
                              const Clock& clock = SteadyClock{},
                              WorkPart work = {});

} // namespace wakesurf::core
