// A surface at successive times, built once: what becomes an animation or a series of files. A streak or time
// surface moves, a path or stream surface grows from its rake, a level set is another one at each time.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// True of surfaces that differ from time to time of a clock.
bool moves(const SurfaceParameters& parameters);

/// Returns the age of a surface, from its (first) release, at a time of the clock, clamped to the times of
/// the surface; at its end without a time.
double age_at(const SurfaceParameters& parameters, std::optional<double> time);

/// Shows a surface at times between `from` and `to`, in any order; in the order in which the surface moves
/// every step is computed once. Thread safety: one thread at a time.
class Evolution {
  public:
    /// Builds a path or stream surface whole; begins others. @param clock  outlives it
    /// Error: what build_surface and PlayedSurface::start report.
    static Result<Evolution> start(const SurfacePlan& plan,
                                   const Clock& clock,
                                   const std::stop_token& stop,
                                   const WorkPart& work = {});

    ~Evolution();
    Evolution(Evolution&&) noexcept;
    Evolution& operator=(Evolution&&) noexcept;

    /// The surface at one time.
    struct State {
        /// Ids last as long as this evolution, but for a level set, of which no vertex lasts.
        KeyedMesh mesh;
        SurfaceStatistics statistics; ///< up to that time
        std::vector<double> times;    ///< at which each vertex is there
    };

    /// @param time  clamped to the times of the surface; of a stream surface `from` plus the age
    /// Error: Cancelled, what stepping and building report.
    Result<State> at(double time, const std::stop_token& stop, const WorkPart& work = {});

  private:
    struct Held;
    explicit Evolution(std::unique_ptr<Held> held);

    std::unique_ptr<Held> held_;
};

} // namespace wakesurf::core
