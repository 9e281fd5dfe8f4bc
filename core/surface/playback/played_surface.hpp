// A streak or time surface at any time of a clock: its history.
#pragma once

#include "core/surface/moving/surface_history.hpp"

#include <limits>
#include <stop_token>
#include <string>

namespace wakesurf::core {

/// Thread safety: one thread at a time.
class PlayedSurface {
  public:
    /// @param clock         outlives it
    /// @param budget_bytes  of what is kept to step back to
    /// Error: what MovingSurface::start reports.
    static Result<PlayedSurface> start(const SurfacePlan& plan,
                                       std::size_t budget_bytes,
                                       const Clock& clock,
                                       const std::stop_token& stop,
                                       const WorkPart& work = {});

    struct Shown {
        KeyedMesh mesh; ///< ids last as long as this surface
        SurfaceStatistics statistics;
        double time = 0.0; ///< at which all its vertices are there
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
    explicit PlayedSurface(SurfaceHistory history);

    const SurfacePlan& plan() const { return history_.surface().state().plan->request.plan; }

    Result<KeyedMesh> mesh_at(double age, const std::stop_token& stop, const WorkPart& work);

    SurfaceHistory history_;
    double from_;
    double sign_;                                           ///< which way time runs
    double most_ = std::numeric_limits<double>::infinity(); ///< readable age
    std::string stopped_;
};

} // namespace wakesurf::core
