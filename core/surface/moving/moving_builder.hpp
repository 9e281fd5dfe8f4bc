// A streak or time surface from its plan to its mesh at `to`: the moving surface run to its end. What every
// mesh that is shown of one needs, finished or played: cells that face the same way whichever way time
// runs, and statistics.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_statistics.hpp"

#include <stop_token>

namespace wakesurf::core {

/// Builds a streak or time surface for build_surface.
Result<Surface> build_moving_surface(const SurfacePlan& plan,
                                     std::stop_token stop,
                                     const Clock& clock,
                                     const WorkPart& work = {});

/// Mirrors the cells of a surface that goes back in time.
void mirror_cells(QuadComplex& mesh);

/// Fills in the statistics of the mesh: quads, vertices, approximated ones, the longest edge, the estimated
/// error.
void count(SurfaceStatistics& statistics, const QuadComplex& mesh);

} // namespace wakesurf::core
