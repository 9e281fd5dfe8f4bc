// A streak or time surface at any time of the session's clock: the engine's history of it, for one direction of time or for
// both.
#pragma once

#include "core/surface/moving/surface_history.hpp"
#include "server/session/surface_job.hpp"

#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Thread safety: one thread at a time.
class PlayedSurface {
  public:
    /// @param job           outlives it
    /// @param budget_bytes  of what is kept to step back to
    /// Error: what core::MovingSurface::start reports.
    static core::Result<PlayedSurface> start(const SurfaceJob& job,
                                             std::size_t budget_bytes,
                                             const core::Clock& clock,
                                             const std::stop_token& stop,
                                             const core::WorkPart& work = {});

    struct Shown {
        core::KeyedMesh mesh; ///< ids last as long as this surface
        core::SurfaceStatistics statistics;
        core::VertexId first_backward =
            core::no_vertex;        ///< from here on of the part that goes back
        double time = 0.0;          ///< at which the vertices are there
        double time_backward = 0.0; ///< likewise of that part

        std::vector<double> times() const;
    };

    /// @param age  since the (first) release, up to the integration time
    /// @return     where a time-step in its way cannot be read it is shown at the last one before that can, and its statistics
    ///             say why
    /// Error: Cancelled, what stepping reports.
    core::Result<Shown>
    at(double age, const std::stop_token& stop, const core::WorkPart& work = {});

    /// Another budget for what is kept to step back to.
    void limit(std::size_t budget_bytes);

    /// What it takes.
    std::size_t bytes() const;

  private:
    struct Part {
        core::SurfaceHistory history;
        double from, sign;
        double most = std::numeric_limits<double>::infinity(); ///< readable age
    };

    core::Result<core::KeyedMesh>
    part_at(Part& part, double age, const std::stop_token& stop, const core::WorkPart& work);

    std::vector<Part> parts_;
    std::string stopped_;
};

} // namespace wakesurf::server
