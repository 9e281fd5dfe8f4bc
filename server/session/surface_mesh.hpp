// A surface computed once and whole, as it is at a time of the session's clock: what is downloaded. By the same code as what is
// shown then, without what live surfaces keep between two times.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/surface_statistics.hpp"
#include "server/session/surface_job.hpp"

#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::server {

struct SurfaceMesh {
    core::QuadComplex mesh;
    core::SurfaceStatistics statistics;
    std::vector<double> times; ///< at which each vertex is there
};

/// @param time  nothing: at its end. Surfaces that do not move ignore it
/// @param work  told what memory it takes, in the end that of the mesh
/// Error: what core::build_surface and PlayedSurface report.
core::Result<SurfaceMesh> surface_mesh(const SurfaceJob& job,
                                       std::optional<double> time,
                                       const core::Clock& clock,
                                       const std::stop_token& stop,
                                       const core::WorkPart& work = {});

} // namespace wakesurf::server
