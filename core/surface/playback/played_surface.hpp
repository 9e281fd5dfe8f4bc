// A streak or time surface at any time of a clock: its history, for one direction of time or for both.
#pragma once

#include "core/surface/moving/surface_history.hpp"
#include "core/surface/rake.hpp"

#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// Thread safety: one thread at a time.
class PlayedSurface {
  public:
    /// @param flow, clock   outlive it
    /// @param budget_bytes  of what is kept to step back to
    /// Error: what MovingSurface::start reports.
    static Result<PlayedSurface> start(const Flow& flow,
                                       const Rake& rake,
                                       const SurfaceParameters& parameters,
                                       std::size_t budget_bytes,
                                       const Clock& clock,
                                       const std::stop_token& stop,
                                       const WorkPart& work = {});

    struct Shown {
        KeyedMesh mesh; ///< ids last as long as this surface
        SurfaceStatistics statistics;
        VertexId first_backward = no_vertex; ///< from here on of the part that goes back
        double time = 0.0;                   ///< at which the vertices are there
        double time_backward = 0.0;          ///< likewise of that part

        std::vector<double> times() const;
    };

    /// @param age  since the (first) release, up to the integration time
    /// @return     where a time-step in its way cannot be read it is shown at the last one before that can, and its statistics
    ///             say why
    /// Error: Cancelled, what stepping reports.
    Result<Shown> at(double age, const std::stop_token& stop, const WorkPart& work = {});

    /// Another budget for what is kept to step back to.
    void limit(std::size_t budget_bytes);

    /// What it takes.
    std::size_t bytes() const;

  private:
    struct Part {
        SurfaceHistory history;
        double from, sign;
        double most = std::numeric_limits<double>::infinity(); ///< readable age
    };

    Result<KeyedMesh>
    part_at(Part& part, double age, const std::stop_token& stop, const WorkPart& work);

    PlayedSurface(const Flow& flow, const Rake& rake, const SurfaceParameters& parameters)
        : flow_(&flow), rake_(rake), parameters_(parameters) {}

    const Flow* flow_;
    Rake rake_;
    SurfaceParameters parameters_;
    std::vector<Part> parts_;
    std::string stopped_;
};

} // namespace wakesurf::core
