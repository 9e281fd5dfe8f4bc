// An integral curve (streamline or pathline) as its integration leaves it: accepted steps with dense output,
// so that a surface can take vertices anywhere on it without a new integration.
#pragma once

#include "core/base/vec3.hpp"
#include "core/base/work_memory.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace wakesurf::core {

enum class CurveEnd : std::uint8_t { Running, Time, Domain, Obstacle, Stagnation, Budget };

struct Curve;
struct CurveStep;

/// Called after each step: the curve ends at `curve.last` then, which may be within the step. Returns false
/// to end the curve.
using StepWatch = std::function<bool(const Curve& curve, const CurveStep& step)>;

/// Takes steps of controlled error (Dopri5), or steps that are all as long (Rk4).
enum class IntegrationMethod { Dopri5, Rk4 };

/// Options of integrating curves.
struct TraceOptions {
    /// The method of the steps.
    using Method = IntegrationMethod;
    Method method = Method::Dopri5; ///< of the steps
    /// Takes the field as it is at `Curve::release` (stream); false: it moves on (path).
    bool frozen = false;
    double tolerance = 1e-6;   ///< Dopri5: error allowed per unit length
    double step = 0.0;         ///< Rk4: the time step; Dopri5: the first one tried, 0: chosen
    double longest_step = 0.0; ///< arc length a step may cover, in the dataset's length unit; > 0
    double stagnation_speed = 0.0;   ///< a slower particle may end: at_rest.hpp says which
    std::size_t most_steps = 50'000; ///< attempts after which it ends with Budget: 184 bytes each
    bool stretch = false;  ///< transport the tangent across the rake: 96 bytes a step more
    bool expansion = true; ///< find CurveStep::expansion, which is 0 otherwise
    bool smooth = false;   ///< stored data: tricubic in space and cubic in time instead of linear
    WorkMemory* memory = nullptr; ///< what the steps take is counted there, where there is one
    /// Sees the steps of a frozen field, of which none is kept then. Called from several threads, for
    /// different curves.
    const StepWatch* watch = nullptr;
};

/// The dense output of one accepted step, Hairer, Norsett, Wanner, Solving ODEs I, II.6: y(theta) = c0 +
/// theta (c1 + (1 - theta)(c2 + theta (c3 + (1 - theta) c4))); xyz is the position, w the arc length.
struct CurveStep {
    double time = 0.0;           ///< since release
    double dt = 0.0;             ///< negative upstream
    std::array<glm::dvec4, 5> c; ///< coefficients of the polynomial
    /// The integrator's estimate of the error at the step's end, a length; RK4: 0.
    float error = 0.0f;
    float expansion = 0.0f; ///< how much the fluid round it expands meanwhile, as of Carried

    /// Returns the position and arc length at a part of the step, 0 to 1.
    glm::dvec4 at(double theta) const {
        const double other = 1.0 - theta;
        return c[0] + theta * (c[1] + other * (c[2] + theta * (c[3] + other * c[4])));
    }
};

/// The transported tangent dx/ds during a step, of third order contact at both ends.
struct StretchStep {
    Vec3 start{0.0};        ///< the tangent where the step begins
    Vec3 end{0.0};          ///< and where it ends
    Vec3 start_change{0.0}; ///< how it changes there, by theta
    Vec3 end_change{0.0};   ///< the same

    /// Returns the tangent at a part of the step, 0 to 1.
    Vec3 at(double theta) const {
        const double other = 1.0 - theta;
        const Vec3 change = end - start;
        return start + theta * change +
               theta * other * (other * (start_change - change) - theta * (end_change - change));
    }

    /// Returns how it changes there, by theta.
    Vec3 change_at(double theta) const {
        const double other = 1.0 - theta;
        const Vec3 change = end - start;
        const Vec3 early = start_change - change;
        const Vec3 late = end_change - change;
        return change + (other - theta) * (other * early - theta * late) -
               theta * other * (early + late);
    }
};

/// A point of a curve.
struct CurvePoint {
    Vec3 position{0.0}; ///< where it is
    double time = 0.0;  ///< since release; negative upstream
    double arc = 0.0;   ///< arc length from the seed
    Vec3 stretch{0.0};  ///< dx/ds there, with TraceOptions::stretch
};

/// A curve that Flow::trace fills. The seed, release time and duration are inputs.
struct Curve {
    Vec3 seed{0.0};         ///< where it begins
    Vec3 seed_tangent{0.0}; ///< dc/ds at the seed; used with TraceOptions::stretch
    double release = 0.0;   ///< simulation time
    double duration = 0.0;  ///< signed: negative integrates upstream

    std::vector<CurveStep> steps;       ///< those that were accepted, in order
    std::vector<StretchStep> stretches; ///< one a step with TraceOptions::stretch, else none
    CurveEnd end = CurveEnd::Running;   ///< why it ended
    CurvePoint last;                    ///< where the curve ends
    double next_dt = 0.0;     ///< the integrator's proposal, kept between sliding-window intervals
    std::size_t attempts = 0; ///< accepted and rejected steps
    std::size_t wanted = 0;   ///< bytes that it waits for, where tracing can wait

    /// Returns the point at an arc length from the seed, 0..last.arc. Cost: O(log steps).
    CurvePoint at_arc(double arc) const;

    /// Returns the point so long after the release, 0..last.time, negative upstream. Cost: O(log steps).
    CurvePoint at_time(double time) const;

    /// Cuts the last step to the part that ends where the curve does, so that another can follow; drops one that came no
    /// farther.
    void cut_last_step();
};

/// Takes the memory for one step more, if it is free; otherwise the curve has to wait for it.
inline bool room_for_step(Curve& curve, const TraceOptions& options) {
    const std::size_t now = curve.steps.size();
    if (options.memory == nullptr || options.watch != nullptr || now < curve.steps.capacity())
        return true;
    const std::size_t more = std::max<std::size_t>(now, 1);
    const std::size_t bytes =
        more * (sizeof(CurveStep) + (options.stretch ? sizeof(StretchStep) : 0));
    if (!options.memory->grow_within_free(bytes)) {
        curve.wanted = bytes;
        return false;
    }
    curve.steps.reserve(now + more);
    return true;
}

/// Adds a step. False: there is no memory for it, and tracing should end.
inline bool keep_step(Curve& curve, const CurveStep& step, const TraceOptions& options) {
    const std::size_t before = curve.steps.capacity();
    const std::size_t bytes = sizeof(CurveStep) + (options.stretch ? sizeof(StretchStep) : 0);
    if (options.memory != nullptr && curve.steps.size() == before &&
        !options.memory->grow(std::max<std::size_t>(before, 1) * bytes))
        return false;
    curve.steps.push_back(step);
    return true;
}

/// Returns why tracing ended early: it was stopped, or there was no memory.
inline Error cut_short(const TraceOptions& options) {
    if (options.memory != nullptr && options.memory->exhausted())
        return options.memory->refusal();
    return {Error::Code::Cancelled, "the integration was cancelled", ""};
}

/// Takes points off a curve in order of arc length: no search, and the first guess of each is where the last
/// one was.
class CurveReader {
  public:
    /// Reads a curve, which must live as long.
    explicit CurveReader(const Curve& curve) : curve_(curve) {}

    /// Returns what Curve::at_arc does.
    CurvePoint at_arc(double arc);

  private:
    const Curve& curve_;
    std::size_t step_ = 0;
};

} // namespace wakesurf::core
