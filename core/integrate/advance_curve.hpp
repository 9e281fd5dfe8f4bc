// Carries one particle from where its curve ends to a given time, or until it leaves the domain, meets an
// obstacle or stands still. Works on any field with `velocity(position, time)`, continued smoothly a step beyond
// the domain, and `status(position)`.
#pragma once

#include "core/base/point_status.hpp"
#include "core/integrate/curve.hpp"
#include "core/integrate/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <stop_token>

namespace wakesurf::core {

template <class F>
concept VelocityField = requires(const F& field, const Vec3& p, double t) {
    { field.velocity(p, t) } -> std::convertible_to<Vec3>;
    { field.status(p) } -> std::same_as<PointStatus>;
};

/// theta of the last point of a step that is still inside, 1 when all of it is. Looks at points an eighth
/// of the longest step apart, then bisects to the crossing.
template <VelocityField Field>
double
inside_until(const Field& field, const CurveStep& step, double longest_step, PointStatus& left_to) {
    const double length = std::abs(step.c[1].w);
    const int looks = std::clamp(static_cast<int>(std::ceil(8.0 * length / longest_step)), 1, 16);
    double inside = 0.0;
    for (int i = 1; i <= looks; ++i) {
        double outside = static_cast<double>(i) / looks;
        left_to = field.status(Vec3(step.at(outside)));
        if (left_to == PointStatus::Inside) {
            inside = outside;
            continue;
        }
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (inside + outside);
            const PointStatus status = field.status(Vec3(step.at(middle)));
            if (status == PointStatus::Inside)
                inside = middle;
            else {
                outside = middle;
                left_to = status;
            }
        }
        return inside;
    }
    return 1.0;
}

/// The tangent across the rake carried along: w' = (grad v) w by the midpoint rule over the step, the gradient by
/// central differences (second order; it colours, it does not place vertices).
template <VelocityField Field>
Vec3 carry_stretch(const Field& field,
                   const CurveStep& step,
                   double field_time,
                   double difference) {
    const Vec3 middle(step.at(0.5));
    const auto along = [&](const Vec3& w) {
        const double length = glm::length(w);
        if (length == 0.0)
            return Vec3(0.0);
        const Vec3 offset = w * (difference / length);
        return (field.velocity(middle + offset, field_time) -
                field.velocity(middle - offset, field_time)) *
               (length / (2.0 * difference));
    };
    return step.stretch + step.dt * along(step.stretch + 0.5 * step.dt * along(step.stretch));
}

/// Advances until `until` (time since release, same sign as the duration).
/// Returns false if `stop` fired or there is no memory. Thread safety: disjoint curves may be advanced concurrently.
template <VelocityField Field>
bool advance_curve(const Field& field,
                   Curve& curve,
                   const TraceOptions& options,
                   double until,
                   const std::stop_token& stop) {
    const double sign = curve.duration < 0.0 ? -1.0 : 1.0;
    const auto field_time = [&](double time) {
        return options.frozen ? curve.release : curve.release + time;
    };
    const auto velocity = [&](const Vec3& p, double t) {
        return field.velocity(p, options.frozen ? curve.release : t);
    };
    if (curve.steps.empty()) {
        curve.last = {curve.seed, 0.0, 0.0, curve.seed_tangent};
        if (const PointStatus status = field.status(curve.seed); status != PointStatus::Inside)
            curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
    }
    Vec3 v = velocity(curve.last.position, field_time(curve.last.time));
    while (curve.end == CurveEnd::Running) {
        if ((curve.attempts & 63u) == 0 && stop.stop_requested())
            return false;
        const double left = std::abs(until - curve.last.time);
        if (left <= 1e-12 * std::abs(curve.duration)) {
            if (std::abs(until) >= std::abs(curve.duration) * (1.0 - 1e-12))
                curve.end = CurveEnd::Time;
            return true;
        }
        const double speed = glm::length(v);
        if (!(speed > options.stagnation_speed)) { // also ends on NaN
            curve.end = CurveEnd::Stagnation;
            return true;
        }
        const double cap = options.longest_step / speed;
        double dt = options.step > 0.0 &&
                            (options.method == TraceOptions::Method::Rk4 || curve.next_dt == 0.0)
                        ? options.step
                    : curve.next_dt > 0.0 ? curve.next_dt
                                          : 0.1 * cap;
        if (options.method == TraceOptions::Method::Dopri5)
            dt = std::min(dt, cap);
        const bool cut = dt >= left;
        const double wanted = dt;
        dt = std::min(dt, left);

        const glm::dvec4 y(curve.last.position, curve.last.arc);
        const double now = curve.release + curve.last.time;
        RungeKuttaStep step = options.method == TraceOptions::Method::Rk4
                                  ? rk4_step(velocity, y, now, sign * dt, v)
                                  : dopri5_step(velocity, y, now, sign * dt, v);
        ++curve.attempts;
        const double arc = step.dense.c[1].w;
        if (options.method == TraceOptions::Method::Dopri5) {
            // Error per unit length; the floor keeps slow particles from crawling.
            const double allowed = options.tolerance * std::max(arc, 0.05 * options.longest_step);
            curve.next_dt = dt * step_scale(allowed, step.error);
            if (!(step.error <= allowed) && dt * speed > 1e-9 * options.longest_step)
                continue;
            if (cut)
                curve.next_dt = std::max(curve.next_dt, wanted);
        }
        step.dense.time = curve.last.time;
        step.dense.stretch = curve.last.stretch;
        PointStatus status = PointStatus::Inside;
        const double theta = inside_until(field, step.dense, options.longest_step, status);
        const glm::dvec4 end = step.dense.at(theta);
        curve.last.position = Vec3(end);
        curve.last.arc = end.w;
        curve.last.time = cut && theta == 1.0 ? until : step.dense.time + theta * step.dense.dt;
        if (options.stretch)
            curve.last.stretch =
                carry_stretch(field, step.dense, field_time(step.dense.time + 0.5 * step.dense.dt),
                              0.05 * options.longest_step);
        if (!keep_step(curve, step.dense, options))
            return false;
        v = step.velocity;
        if (theta < 1.0)
            curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
        else if (curve.attempts >= options.most_steps)
            curve.end = CurveEnd::Budget;
    }
    return true;
}

} // namespace wakesurf::core
