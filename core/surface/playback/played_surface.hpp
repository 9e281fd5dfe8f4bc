// A streak or time surface at any time of a clock: its history.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_statistics.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>

namespace wakesurf::core {

/// Shows a surface at any time of a clock. Thread safety: one thread at a time.
class PlayedSurface {
  public:
    /// @param clock         outlives it
    /// @param budget_bytes  of what is kept to step back to Error: OverLimit, Cancelled, and what loading a
    ///                      time-step reports. REQUIRES: a streak or a time surface.
    static Result<PlayedSurface> start(const SurfacePlan& plan,
                                       std::size_t budget_bytes,
                                       const Clock& clock,
                                       const std::stop_token& stop,
                                       const WorkPart& work = {});

    ~PlayedSurface();
    PlayedSurface(PlayedSurface&&) noexcept;
    PlayedSurface& operator=(PlayedSurface&&) noexcept;

    /// The surface at one time.
    struct Shown {
        KeyedMesh mesh;               ///< ids last as long as this surface
        SurfaceStatistics statistics; ///< up to that time
        double time = 0.0;            ///< at which all its vertices are there
    };

    /// @param age  since the (first) release, up to the integration time
    /// @return     where a time-step in its way cannot be read it is shown at the last one before that can,
    /// and its statistics say why Error: Cancelled, what stepping reports.
    Result<Shown> at(double age, const std::stop_token& stop, const WorkPart& work = {});

    /// Another budget for what is kept to step back to.
    void limit(std::size_t budget_bytes);

    /// Returns the bytes that it takes.
    std::size_t bytes() const;

  private:
    struct State;
    explicit PlayedSurface(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

} // namespace wakesurf::core
