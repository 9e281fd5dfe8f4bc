// Carries one particle of a moving surface to a given time, or until it leaves the domain, meets an obstacle
// or stands still. Keeps nothing of the way there, unlike advance_curve. Works on any field with `velocity`,
// `derivative` and `status`.
#pragma once

#include "core/base/point_status.hpp"
#include "core/integrate/at_rest.hpp"
#include "core/integrate/divergence.hpp"
#include "core/integrate/particles.hpp"
#include "core/integrate/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>

namespace wakesurf::core {

/// `derivative(p, t, w)` is (grad v) w.
template <class F>
concept CarryingField = requires(const F& field, const Vec3& p, double t) {
    { field.velocity(p, t) } -> std::convertible_to<Vec3>;
    { field.derivative(p, t, p) } -> std::convertible_to<Vec3>;
    { field.status(p) } -> std::same_as<PointStatus>;
};

/// One particle between steps.
struct ParticleState {
    Carried carried;
    double time = 0.0;
    CurveEnd end = CurveEnd::Running;
};

/// The part of a step that a particle completes.
struct Way {
    double part = 1.0; ///< of the step's time; 1: it does not leave
    Vec3 position;
};

/// Finds where on the way from `before` to `after` the particle leaves, on the cubic through both.
template <CarryingField Field>
Way leaves_at(const Field& field,
              const Carried& before,
              const Carried& change,
              const Carried& slope0,
              const Carried& slope1,
              CurveEnd& end) {
    const Vec3 after = before.position + change.position;
    PointStatus status = field.status(after);
    if (status == PointStatus::Inside)
        return {1.0, after};
    CurveStep cubic;
    cubic.dt = 1.0;
    hermite_output(cubic, glm::dvec4(before.position, 0.0), glm::dvec4(change.position, 0.0),
                   glm::dvec4(slope0.position, 0.0), glm::dvec4(slope1.position, 0.0));
    double inside = 0.0;
    double outside = 1.0;
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (inside + outside);
        const PointStatus there = field.status(Vec3(cubic.at(middle)));
        (there == PointStatus::Inside ? inside : outside) = middle;
        status = there == PointStatus::Inside ? status : there;
    }
    if (outside == 1.0 && field.status(after) == PointStatus::Inside)
        return {1.0, after}; // only the straight way is barred: the cubic goes round something
    end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
    return {inside, Vec3(cubic.at(inside))};
}

/// Accepts a step: moves the particle by `change`, or as far as it stays inside.
template <CarryingField Field>
void take_step(const Field& field,
               ParticleState& at,
               const Carried& change,
               const Carried& slope0,
               const Carried& slope1,
               double dt) {
    const Way way = leaves_at(field, at.carried, change, dt * slope0, dt * slope1, at.end);
    at.carried = at.carried + way.part * change;
    at.carried.position = way.position; // not beyond a wall, where the way is not straight
    at.time += way.part * dt;
}

/// A particle's velocity and the change of what it carries.
template <CarryingField Field>
Carried carried_slope(const Field& field, const Carried& y, double t, bool tangents) {
    const Vec3 v = field.velocity(y.position, t);
    if (!tangents)
        return {v};
    if constexpr (requires { field.gradient(y.position, t); }) {
        const auto gradient = field.gradient(y.position, t);
        return {v, gradient(y.along_s), gradient(y.along_t), divergence_of(gradient)};
    } else {
        return {v, field.derivative(y.position, t, y.along_s),
                field.derivative(y.position, t, y.along_t), divergence(field, y.position, t)};
    }
}

/// Returns the number of equal steps that Rk4 divides a length of time into.
inline double rk4_steps(double whole, const AdvanceOptions& options) {
    return std::max(1.0, std::ceil(std::abs(whole) / options.step - 1e-9));
}

/// Takes one of those steps. It leaves the time to the caller unless the particle ends.
template <CarryingField Field>
void rk4_particle_step(const Field& field,
                       ParticleState& at,
                       double dt,
                       const AdvanceOptions& options,
                       bool tangents) {
    const auto slope = [&](const Carried& y, double t) {
        return carried_slope(field, y, t, tangents);
    };
    const Carried k1 = slope(at.carried, at.time);
    const double speed = glm::length(k1.position);
    if (!(speed > options.stagnation_speed) &&
        ends_at_rest(field, at.carried.position, at.time, speed, false)) {
        at.end = end_at_rest(field, at.carried.position);
        return;
    }
    const Carried change = rk4_change(slope, at.carried, at.time, dt, k1);
    // The slope at the end only serves to find a crossing.
    const Carried end_slope{
        field.velocity(at.carried.position + change.position, at.time + dt), {}, {}, 0.0};
    take_step(field, at, change, k1, end_slope, dt);
}

/// @param to        simulation time
/// @param tangents  false: only the position is carried
template <CarryingField Field>
void advance_particle(const Field& field,
                      ParticleState& at,
                      double to,
                      const AdvanceOptions& options,
                      bool tangents) {
    const double whole = to - at.time;
    if (whole == 0.0 || at.end != CurveEnd::Running)
        return;
    if (options.method == AdvanceOptions::Method::Rk4) {
        const double steps = rk4_steps(whole, options);
        const double dt = whole / steps;
        const double start = at.time;
        for (double i = 0; i < steps && at.end == CurveEnd::Running; ++i) {
            at.time = start + i * dt;
            rk4_particle_step(field, at, dt, options, tangents);
        }
        if (at.end == CurveEnd::Running)
            at.time = to;
        return;
    }
    const auto slope = [&](const Carried& y, double t) {
        return carried_slope(field, y, t, tangents);
    };
    const double sign = whole < 0.0 ? -1.0 : 1.0;
    double next = 0.0;
    Carried k1 = slope(at.carried, at.time);
    for (std::size_t attempts = 0; at.end == CurveEnd::Running && at.time != to; ++attempts) {
        if (attempts == options.most_steps) {
            at.end = CurveEnd::Budget;
            return;
        }
        const double speed = glm::length(k1.position);
        if (!(speed > options.stagnation_speed) &&
            ends_at_rest(field, at.carried.position, at.time, speed, false)) {
            at.end = end_at_rest(field, at.carried.position);
            return;
        }
        const double left = std::abs(to - at.time);
        const double cap = options.longest_step / speed;
        const double dt = std::min(next > 0.0 ? std::min(next, cap) : 0.25 * cap, left);
        const auto k = dopri5_stages(slope, at.carried, at.time, sign * dt, k1);
        const double error = dt * glm::length(dopri5_error(k).position);
        const double allowed =
            options.tolerance * std::max(dt * speed, 0.05 * options.longest_step);
        next = dt * step_scale(allowed, error);
        const Carried change = sign * dt * k.rate;
        // From rest it is the way that tells whether the step was short.
        const double way = std::max(dt * speed, glm::length(change.position));
        if (!(error <= allowed) && way > 1e-9 * options.longest_step)
            continue;
        take_step(field, at, change, k1, k.k7, sign * dt);
        if (at.end == CurveEnd::Running && dt == left)
            at.time = to;
        k1 = k.k7;
    }
}

} // namespace wakesurf::core
