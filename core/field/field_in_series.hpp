// A field that is a polynomial in each cell, and a particle's way through it by one Taylor series a cell: no
// step goes across a face, where the field has a kink and Runge-Kutta steps of any order are of second.
#pragma once

#include "core/integrate/advance_curve.hpp"
#include "core/integrate/advance_particle.hpp"

#include <array>
#include <cstddef>
#include <stop_token>
#include <utility>

namespace wakesurf::core {

/// A field whose curves and particles go cell by cell, unless RK4 is asked for.
template <class Field>
concept FieldInSeries = requires {
    &Field::series_steps;
};

/// Steps that carry a particle's tangents with it, w' = (grad v) w by the midpoint rule over either half of a
/// step, in the cell of its series: no point has to be found for them.
template <class Steps>
class CarryingSteps {
  public:
    CarryingSteps(Steps steps, Carried& carried) : steps_(std::move(steps)), carried_(carried) {}

    decltype(auto) field() const { return steps_.field(); }

    PointStatus begin(Curve& curve) { return steps_.begin(curve); }

    StepOutcome attempt(Curve& curve, double left, CurveStep& step) {
        const StepOutcome outcome = steps_.attempt(curve, left, step);
        if (outcome != StepOutcome::Taken)
            return outcome;
        const double half = 0.5 * step.dt;
        const double start = curve.release + curve.last.time;
        std::array w{carried_.along_s, carried_.along_t};
        for (const double middle : {0.25, 0.75}) {
            const auto slope = steps_.gradient(step, middle, start + middle * step.dt);
            for (Vec3& each : w)
                each += half * slope(each + 0.5 * half * slope(each));
        }
        carried_.along_s = w[0];
        carried_.along_t = w[1];
        return outcome;
    }

    auto gradient(const CurveStep& step, double theta, double time) const {
        return steps_.gradient(step, theta, time);
    }

    double inside_until(const CurveStep& step, PointStatus& met) const {
        return steps_.inside_until(step, met);
    }

    bool arrive(Curve& curve) { return steps_.arrive(curve); }

  private:
    Steps steps_;
    Carried& carried_;
};

/// Advances like advance_particle with Method::Dopri5, and keeps nothing of the way. Returns false if `stop`
/// fired: the particle is then on its way.
template <FieldInSeries Field>
bool advance_in_series(const Field& field,
                       ParticleState& at,
                       double to,
                       const AdvanceOptions& options,
                       bool tangents,
                       const std::stop_token& stop = {}) {
    if (to == at.time || at.end != CurveEnd::Running)
        return true;
    TraceOptions trace;
    trace.tolerance = options.tolerance;
    trace.longest_step = options.longest_step;
    trace.stagnation_speed = options.stagnation_speed;
    trace.most_steps = options.most_steps;
    trace.expansion = tangents;
    Curve way;
    way.last.position = way.seed = at.carried.position;
    way.release = at.time;
    way.duration = to - at.time;
    const auto go = [&](auto steps) {
        return advance_steps(std::move(steps), way, trace, way.duration, stop,
                             [&](const CurveStep& step) {
                                 at.carried.expansion += double(step.expansion);
                                 return true;
                             });
    };
    auto steps = field.series_steps(trace, way.duration < 0.0 ? -1.0 : 1.0);
    const bool whole =
        tangents ? go(CarryingSteps(std::move(steps), at.carried)) : go(std::move(steps));
    at.carried.position = way.last.position;
    const bool arrived = way.end == CurveEnd::Time;
    at.time = arrived ? to : way.release + way.last.time;
    at.end = arrived ? CurveEnd::Running : way.end;
    return whole;
}

} // namespace wakesurf::core
