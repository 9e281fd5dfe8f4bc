// A streak or time surface in motion: every vertex is carried in every step, the rake releases new ones, and
// local operations keep the mesh within its limits. Its state is a value: keep a copy to come back to it.
// Source: McLoughlin, Laramee, Zhang, Constructing Streak Surfaces for 3D Unsteady Vector Fields, SCCG 2010.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/moving/moving_plan.hpp"
#include "core/surface/moving/refinement.hpp"
#include "core/surface/moving/step_errors.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>

namespace wakesurf::core {

/// All that a surface is at one time.
struct MovingState {
    /// Replaced when the quad budget makes the surface begin again.
    std::shared_ptr<const MovingPlan> plan;
    MovingMesh mesh;
    double separation = 0.0; ///< raised by the quad budget
    double row_travel = 0.0; ///< how far the fastest particle of the newest row has gone
    bool releasing = false;  ///< the rake still has attached vertices
    std::uint64_t steps = 0;
    std::uint64_t vertex_steps = 0; ///< integrator steps of all vertices
    SurfaceStatistics::Terminated terminated;
    /// Ids from here on were given by the last step's refinement.
    std::uint32_t fresh = 0xffffffffu;
    std::uint64_t torn = 0; ///< cells, see SurfaceStatistics
    StepErrors step_errors;
    double errors_until = 0.0; ///< the steps before are in the errors of the vertices

    std::size_t bytes() const { return memory_of(mesh) + step_errors.bytes(); }
};

/// Steps a streak or time surface forward in the calling thread's oneTBB arena. Thread safety: one thread at
/// a time.
class MovingSurface {
  public:
    /// Returns the surface at `parameters.from`: nothing of a streak surface yet, the whole patch of a time
    /// surface. Where coarse trials show that it would exceed the quad budget, its separation is larger from
    /// the start. Error: OverLimit where not even a tenth of the domain would do, Cancelled, what sampling
    /// reports.
    static Result<MovingSurface> start(const SurfacePlan& plan,
                                       std::stop_token stop,
                                       const Clock& clock,
                                       const WorkPart& work = {});

    /// Carries the surface over one step, as long as it is safe; not beyond `to`. A surface that would exceed
    /// its quad budget is begun again, coarser, and carried to where the step leads. Error: OverLimit as for
    /// start(), and where `work` has no memory, Cancelled within 50 ms, and what loading time-steps
    /// reports; the surface is then of no use but to restore().
    /// @param work  the way from here to `aim`, or to `to` where that is left out
    Result<void> step(double to,
                      std::stop_token stop,
                      const WorkPart& work = {},
                      std::optional<double> aim = std::nullopt);

    /// Steps until `to`.
    Result<void> advance_to(double to, std::stop_token stop, const WorkPart& work = {});

    /// The time the next step towards `to` will reach.
    double next_time(double to, const std::stop_token& stop = {}) const;

    double time() const { return state_.mesh.time; }

    /// Returns `to` in the surface's direction of time.
    double end_time() const { return state_.plan->end; }

    const MovingState& state() const { return state_; }

    /// Goes back, or forward, to a state this surface had. Stepping on from there leads to the same bytes
    /// again.
    void restore(const MovingState& state);

    /// The mesh as it is now, without dead vertices.
    KeyedMesh mesh() const;

    SurfaceStatistics statistics() const;

    /// True where every invariant of the mesh holds; else what does not. Cost: O(cells log cells).
    std::string validate() const;

  private:
    MovingSurface(MovingPlan plan, const Clock& clock);
    static Result<std::optional<std::uint64_t>> most_quads(MovingPlan plan,
                                                           const Clock& clock,
                                                           const std::stop_token& stop,
                                                           const WorkPart& work);
    static Result<MovingPlan> plan_within_budget(const MovingRequest& request,
                                                 BudgetSearch search,
                                                 const std::stop_token& stop,
                                                 const Clock& clock,
                                                 const WorkPart& work);
    Result<bool> begin(const std::stop_token& stop, const WorkPart& work);
    Result<void> begin_within_budget(const std::stop_token& stop, const WorkPart& work);
    Result<void> start_coarser(double until, const std::stop_token& stop, const WorkPart& work);
    Result<bool> move(double now, const std::stop_token& stop, const WorkPart& work);
    Result<double> carry(double to, const AdvanceOptions& options, const std::stop_token& stop);
    Result<bool> refine(double before,
                        const AdvanceOptions& carry,
                        const std::stop_token& stop,
                        const WorkPart& work);
    Result<void> trace_doubtful(const AdvanceOptions& options, const std::stop_token& stop);
    Result<void> sample_velocity(const std::stop_token& stop);
    double leading_speed(double time, const std::stop_token& stop) const;
    bool refines() const;

    const Flow* flow_;
    const Clock* clock_;
    MovingState state_;
    RefinementMemory refinement_memory_;
    SurfaceStatistics::Seconds seconds_;
};

} // namespace wakesurf::core
