// Steps along a curve through any field with a velocity: Dormand-Prince 5(4) under error control, or RK4 of
// one length. The field is continued smoothly a step beyond the domain.
#pragma once

#include "core/integrate/advance_curve.hpp"
#include "core/integrate/runge_kutta.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

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
