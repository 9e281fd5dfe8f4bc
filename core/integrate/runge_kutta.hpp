// Runge-Kutta steps with dense output through any field with a velocity: Dormand-Prince 5(4) under error
// control, and classic RK4 of one length. The state is position and arc length; the field is continued
// smoothly a step beyond the domain. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential
// Equations I, II.5-II.6.
#pragma once

#include "core/integrate/advance_curve.hpp"
#include "core/integrate/curve.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

struct RungeKuttaStep {
    CurveStep dense;
    Vec3 velocity{0.0}; ///< at the end of the step
    double error = 0.0; ///< estimated position error; 0 for RK4
};

/// Returns d(position, arc)/dt; `sign` is the sign of dt, so that the arc length grows in either direction of
/// time. `velocity(position, time)` must be defined a step beyond the domain.
template <class Velocity>
glm::dvec4 slope(const Velocity& velocity, const glm::dvec4& y, double time, double sign) {
    const Vec3 v = velocity(Vec3(y), time);
    return {v, sign * glm::length(v)};
}

/// Third-order contact at both ends: the cubic Hermite polynomial in the form CurveStep evaluates.
inline void hermite_output(CurveStep& step,
                           const glm::dvec4& start,
                           const glm::dvec4& change,
                           const glm::dvec4& slope0,
                           const glm::dvec4& slope1) {
    step.c[0] = start;
    step.c[1] = change;
    step.c[2] = step.dt * slope0 - change;
    step.c[3] = change - step.dt * slope1 - step.c[2];
    step.c[4] = glm::dvec4(0.0);
}

/// The stages of a Dormand-Prince 5(4) step that the solutions and their error are made of; y + dt * rate is
/// its end.
template <class State>
struct Dopri5Stages {
    State k1, k3, k4, k5, k6, k7, rate;
};

/// @param f  slope of a State at (State, time); states add and scale
template <class State, class Slope>
Dopri5Stages<State>
dopri5_stages(const Slope& f, const State& y, double time, double dt, const State& k1) {
    const auto k = [&](double c, const State& increment) {
        return f(y + dt * increment, time + c * dt);
    };
    const State k2 = k(0.2, 0.2 * k1);
    const State k3 = k(0.3, 3.0 / 40 * k1 + 9.0 / 40 * k2);
    const State k4 = k(0.8, 44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3);
    const State k5 = k(8.0 / 9, 19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 -
                                    212.0 / 729 * k4);
    const State k6 = k(1.0, 9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 +
                                49.0 / 176 * k4 - 5103.0 / 18656 * k5);
    const State rate = 35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 +
                       11.0 / 84 * k6;
    return {k1, k3, k4, k5, k6, k(1.0, rate), rate};
}

/// Returns the difference of the fifth and fourth order solutions, over dt.
template <class State>
State dopri5_error(const Dopri5Stages<State>& k) {
    return 71.0 / 57600 * k.k1 - 71.0 / 16695 * k.k3 + 71.0 / 1920 * k.k4 -
           17253.0 / 339200 * k.k5 + 22.0 / 525 * k.k6 - 1.0 / 40 * k.k7;
}

/// Returns the factor by which the next step may be longer than one with this error; NaN makes it shorter.
inline double step_scale(double allowed, double error) {
    if (error == 0.0)
        return 5.0;
    const double scale = 0.9 * std::pow(allowed / error, 0.2);
    return scale > 0.2 ? std::min(scale, 5.0) : 0.2;
}

/// @param time absolute time at which y holds; @param v0 velocity there
template <class Velocity>
RungeKuttaStep
dopri5_step(const Velocity& f, const glm::dvec4& y, double time, double dt, const Vec3& v0) {
    const double sign = dt < 0.0 ? -1.0 : 1.0;
    const glm::dvec4 k1(v0, sign * glm::length(v0));
    const auto k = dopri5_stages(
        [&](const glm::dvec4& at, double t) { return slope(f, at, t, sign); }, y, time, dt, k1);

    RungeKuttaStep result;
    result.dense.dt = dt;
    hermite_output(result.dense, y, dt * k.rate, k1, k.k7);
    result.dense.c[4] =
        dt * (-12715105075.0 / 11282082432.0 * k1 + 87487479700.0 / 32700410799.0 * k.k3 -
              10690763975.0 / 1880347072.0 * k.k4 + 701980252875.0 / 199316789632.0 * k.k5 -
              1453857185.0 / 822651844.0 * k.k6 + 69997945.0 / 29380423.0 * k.k7);
    result.velocity = Vec3(k.k7);
    result.error = std::abs(dt) * glm::length(Vec3(dopri5_error(k)));
    return result;
}

/// Returns what a classic RK4 step changes y by.
template <class State, class Slope>
State rk4_change(const Slope& f, const State& y, double time, double dt, const State& k1) {
    const State k2 = f(y + 0.5 * dt * k1, time + 0.5 * dt);
    const State k3 = f(y + 0.5 * dt * k2, time + 0.5 * dt);
    const State k4 = f(y + dt * k3, time + dt);
    return dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

template <class Velocity>
RungeKuttaStep
rk4_step(const Velocity& f, const glm::dvec4& y, double time, double dt, const Vec3& v0) {
    const double sign = dt < 0.0 ? -1.0 : 1.0;
    const glm::dvec4 k1(v0, sign * glm::length(v0));
    const glm::dvec4 change = rk4_change(
        [&](const glm::dvec4& at, double t) { return slope(f, at, t, sign); }, y, time, dt, k1);

    RungeKuttaStep result;
    result.dense.dt = dt;
    const glm::dvec4 end = slope(f, y + change, time + dt, sign);
    hermite_output(result.dense, y, change, k1, end);
    result.velocity = Vec3(end);
    return result;
}

/// Makes Runge-Kutta steps; a CurveSteps. It keeps references to the field and the options.
template <VelocityField Field>
class RungeKuttaSteps {
  public:
    /// @param sign  +1 downstream, -1 upstream
    RungeKuttaSteps(const Field& field, const TraceOptions& options, double sign)
        : field_(field), options_(options), sign_(sign) {}

    const Field& field() const { return field_; }

    /// The velocity where the curve ends, as the step before has it.
    using Waypoint = Vec3;

    Waypoint waypoint() const { return velocity_; }

    PointStatus resume(const Waypoint& from) {
        velocity_ = from;
        return PointStatus::Inside;
    }

    PointStatus begin(const Curve& curve) {
        velocity_ = velocity(curve, curve.last.position, curve.release + curve.last.time);
        return curve.attempts == 0 ? field_.status(curve.seed) : PointStatus::Inside;
    }

    StepOutcome attempt(Curve& curve, double left, CurveStep& step) {
        const double speed = glm::length(velocity_);
        const double now = curve.release + curve.last.time;
        if (!(speed > options_.stagnation_speed) &&
            ends_at_rest(field_, curve.last.position, now, speed, options_.frozen))
            return StepOutcome::Stagnation;
        const bool controlled = options_.method == TraceOptions::Method::Dopri5;
        const double wanted = wanted_dt(curve, speed);
        const double dt = std::min(wanted, left);
        const auto at = [&](const Vec3& p, double t) { return velocity(curve, p, t); };
        const glm::dvec4 y(curve.last.position, curve.last.arc);
        const RungeKuttaStep next = controlled ? dopri5_step(at, y, now, sign_ * dt, velocity_)
                                               : rk4_step(at, y, now, sign_ * dt, velocity_);
        if (controlled) {
            // Error per unit length; the floor keeps slow particles from crawling.
            const double arc = next.dense.c[1].w;
            const double allowed = options_.tolerance * std::max(arc, 0.05 * options_.longest_step);
            curve.next_dt = dt * step_scale(allowed, next.error);
            // From rest it is the way that tells whether the step was short.
            const double way = std::max(dt * speed, arc);
            if (!(next.error <= allowed) && way > 1e-9 * options_.longest_step)
                return StepOutcome::Again;
            if (wanted >= left) // cut short: the error allows more
                curve.next_dt = std::max(curve.next_dt, wanted);
        }
        step = next.dense;
        step.error = static_cast<float>(next.error);
        end_velocity_ = next.velocity;
        return StepOutcome::Taken;
    }

    double inside_until(const CurveStep& step, PointStatus& met) const {
        return core::inside_until(field_, step, options_.longest_step, met);
    }

    bool arrive(const Curve&) {
        velocity_ = end_velocity_;
        return true;
    }

  private:
    Vec3 velocity(const Curve& curve, const Vec3& p, double t) const {
        return field_.velocity(p, options_.frozen ? curve.release : t);
    }

    /// Were it not for the end of the time that is left.
    double wanted_dt(const Curve& curve, double speed) const {
        if (options_.method == TraceOptions::Method::Rk4 && options_.step > 0.0)
            return options_.step;
        const double cap = options_.longest_step / speed;
        double dt = 0.1 * cap;
        if (curve.next_dt > 0.0)
            dt = curve.next_dt;
        else if (options_.step > 0.0)
            dt = options_.step;
        return options_.method == TraceOptions::Method::Dopri5 ? std::min(dt, cap) : dt;
    }

    const Field& field_;
    const TraceOptions& options_;
    double sign_;
    Vec3 velocity_{0.0}; ///< where the curve ends
    Vec3 end_velocity_{0.0};
};

} // namespace wakesurf::core
