// A field that is a polynomial in each cell, and a particle's way through it by one Taylor series a cell: no
// step goes across a face, where the field has a kink and Runge-Kutta steps of any order are of second.
#pragma once

#include "core/integrate/advance_curve.hpp"
#include "core/integrate/advance_particle.hpp"

#include <glm/mat2x3.hpp>

#include <cstddef>
#include <stop_token>
#include <utility>

namespace wakesurf::core {

/// A field whose curves and particles go cell by cell, unless RK4 is asked for.
template <class Field>
concept FieldInSeries = requires {
    &Field::series_steps;
};

/// Steps that carry with a particle its tangents, w' = (grad v) w, by the classic Runge-Kutta formula, and how
/// much the fluid expands, by the midpoint rule. All of it in the cell of the series: no point has to be found.
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
        constexpr int parts = [] {
            if constexpr (requires { Steps::tangent_steps; })
                return Steps::tangent_steps;
            else
                return 1;
        }();
        constexpr double part = 1.0 / parts;
        const double time = curve.release + curve.last.time;
        const auto gradient = [&](double theta) {
            return steps_.gradient(step, theta, time + theta * step.dt);
        };
        const auto change = [&](const auto& slope, const glm::dmat2x3& w) {
            return part * step.dt * glm::dmat2x3(slope(w[0]), slope(w[1]));
        };
        glm::dmat2x3 w(carried_.along_s, carried_.along_t);
        for (double theta = 0.0; theta < 1.0; theta += part) {
            const auto k1 = change(gradient(theta), w);
            const auto middle = gradient(theta + 0.5 * part);
            carried_.expansion += part * step.dt * divergence_of(middle);
            const auto k2 = change(middle, w + 0.5 * k1);
            const auto k3 = change(middle, w + 0.5 * k2);
            w += (k1 + 2.0 * (k2 + k3) + change(gradient(theta + part), w + k3)) / 6.0;
        }
        carried_.along_s = w[0];
        carried_.along_t = w[1];
        return outcome;
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
    trace.expansion = false; // CarryingSteps finds it
    Curve way;
    way.last.position = way.seed = at.carried.position;
    way.release = at.time;
    way.duration = to - at.time;
    const auto go = [&](auto steps) {
        return advance_steps(std::move(steps), way, trace, way.duration, stop,
                             [](const CurveStep&) { return true; });
    };
    const double sign = way.duration < 0.0 ? -1.0 : 1.0;
    auto steps = [&] {
        if constexpr (requires { field.particle_steps(trace, sign); })
            return field.particle_steps(trace, sign);
        else
            return field.series_steps(trace, sign);
    }();
    const bool whole =
        tangents ? go(CarryingSteps(std::move(steps), at.carried)) : go(std::move(steps));
    at.carried.position = way.last.position;
    const bool arrived = way.end == CurveEnd::Time;
    at.time = arrived ? to : way.release + way.last.time;
    at.end = arrived ? CurveEnd::Running : way.end;
    return whole;
}

} // namespace wakesurf::core
