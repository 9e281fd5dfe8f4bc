// A surface at a time of a clock, computed once and whole: what is downloaded and printed. By the same code
// as what is shown then, without what live surfaces keep between two times.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/playback/evolution.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// The surface at one time.
struct SurfaceAt {
    QuadComplex mesh;             ///< as it is then
    SurfaceStatistics statistics; ///< up to that time
    std::vector<double> times;    ///< at which each vertex is there
    /// As of Surface.
    std::optional<double> ended{};
};

/// @param time  nothing: at its end. Surfaces that do not move ignore it
/// @param work  told what memory it takes, in the end that of the mesh
/// Error: what build_surface and PlayedSurface report.
Result<SurfaceAt> surface_at(const SurfacePlan& plan,
                             std::optional<double> time,
                             const Clock& clock,
                             const std::stop_token& stop,
                             const WorkPart& work = {});

} // namespace wakesurf::core
