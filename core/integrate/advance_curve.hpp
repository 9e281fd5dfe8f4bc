// Carries one particle from where its curve ends to a given time, or until it leaves the domain, meets an
// obstacle or stands still. One loop for steps of every kind: by Runge-Kutta through any field
// (runge_kutta.hpp), by Taylor series through the cells of a grid (field/trilinear_steps.hpp) or of a
// mesh (field/cells/cell_steps.hpp).
#pragma once

#include "core/base/point_status.hpp"
#include "core/integrate/at_rest.hpp"
#include "core/integrate/cursor_of.hpp"
#include "core/integrate/curve.hpp"
#include "core/integrate/divergence.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>
#include <variant>

namespace wakesurf::core {

template <class F>
concept VelocityField = requires(const F& field, const Vec3& p, double t) {
    { field.velocity(p, t) } -> std::convertible_to<Vec3>;
    /// Returns (grad v) w, here of a vector p.
    { field.derivative(p, t, p) } -> std::convertible_to<Vec3>;
    { field.status(p) } -> std::same_as<PointStatus>;
};

/// The outcome of an attempted step. Again: its error was too large, the next one will be shorter.
/// Stagnation: the particle ends at rest (at_rest.hpp), or its velocity is not a number.
enum class StepOutcome { Taken, Again, Stagnation };

/// The steps of one curve: its position, the length of a step and its formula.
template <class S>
concept CurveSteps = requires(
    S& steps, const S& const_steps, Curve& curve, CurveStep& step, double left, PointStatus& to) {
    { const_steps.field() } -> VelocityField;
    /// Goes to where the curve ends, before the first step of a call. Returns whether it may go on from
    /// there.
    { steps.begin(curve) } -> std::same_as<PointStatus>;
    /// Tries a step of at most `left`. Taken: `step` has its points and its `dt`, which is `left` in size
    /// where that ends it.
    { steps.attempt(curve, left, step) } -> std::same_as<StepOutcome>;
    /// theta of the last point of the step that is still inside, 1 when all of it is; otherwise `to` says
    /// what it meets.
    { steps.inside_until(step, to) } -> std::same_as<double>;
    /// Goes to the end of the step, where the curve ends now. Returns false where that is the domain's
    /// border.
    { steps.arrive(curve) } -> std::same_as<bool>;
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

/// Carries the tangent across the rake along a step: w' = (grad v) w, by the classic Runge-Kutta formula.
/// @param time  time(theta): of the field then
template <class Field, class Time>
StretchStep
carry_stretch(const Field& field, const CurveStep& step, const Vec3& start, const Time& time) {
    const auto change = [&](double theta, const Vec3& w) {
        return step.dt * field.derivative(Vec3(step.at(theta)), time(theta), w);
    };
    StretchStep out;
    out.start = start;
    out.start_change = change(0.0, start);
    const Vec3 k2 = change(0.5, start + 0.5 * out.start_change);
    const Vec3 k3 = change(0.5, start + 0.5 * k2);
    const Vec3 k4 = change(1.0, start + k3);
    out.end = start + (out.start_change + 2.0 * (k2 + k3) + k4) / 6.0;
    out.end_change = change(1.0, out.end);
    return out;
}

/// The same by the midpoint rule over either half of a step: within the cell of a series the tangent is a
/// polynomial too, and points on the faces belong to the next cell as well.
/// @param early, late  (grad v) w a quarter of the step from its start and from its end, as functions of w
template <class Gradient>
StretchStep
carry_stretch(const Gradient& early, const Gradient& late, double dt, const Vec3& start) {
    StretchStep out;
    out.start = start;
    const double half = 0.5 * dt;
    const Vec3 early_start = early(start);
    const Vec3 middle = start + half * early(start + 0.5 * half * early_start);
    const Vec3 late_middle = late(middle);
    out.end = middle + half * late(middle + 0.5 * half * late_middle);
    out.start_change = dt * (1.5 * early_start - 0.5 * late(start));
    out.end_change = dt * (1.5 * late(out.end) - 0.5 * early(out.end));
    return out;
}

/// Finds what the options ask for of the fluid round the particle during a step: the tangent, which the curve
/// keeps, and how much the fluid expands, by the midpoint rule over the step or, with the tangent, over
/// either half.
template <class Steps>
void carry_neighbourhood(const Steps& steps,
                         Curve& curve,
                         CurveStep& step,
                         const TraceOptions& options) {
    const auto time = [&](double theta) {
        return options.frozen ? curve.release : curve.release + step.time + theta * step.dt;
    };
    const auto expand = [&](double divergence) {
        step.expansion = static_cast<float>(step.dt * divergence);
    };
    if constexpr (requires { steps.gradient(step, 0.5, 0.0); }) {
        if (options.stretch) {
            const auto early = steps.gradient(step, 0.25, time(0.25));
            const auto late = steps.gradient(step, 0.75, time(0.75));
            if (options.expansion)
                expand(0.5 * (divergence_of(early) + divergence_of(late)));
            curve.stretches.push_back(carry_stretch(early, late, step.dt, curve.last.stretch));
        } else if (options.expansion) {
            expand(divergence_of(steps.gradient(step, 0.5, time(0.5))));
        }
    } else {
        if (options.expansion)
            expand(divergence(steps.field(), Vec3(step.at(0.5)), time(0.5)));
        if (options.stretch)
            curve.stretches.push_back(carry_stretch(steps.field(), step, curve.last.stretch, time));
    }
}

inline CurveEnd end_at(PointStatus met) {
    return met == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
}

/// Takes the part of a step that is inside: where the curve ends now.
inline void take_step(Curve& curve, const CurveStep& step, double theta) {
    const glm::dvec4 end = step.at(theta);
    curve.last.position = Vec3(end);
    curve.last.arc = end.w;
    curve.last.time = step.time + theta * step.dt;
    if (curve.stretches.size() > curve.steps.size())
        curve.last.stretch = curve.stretches.back().at(theta);
}

/// The type of the place between two steps, for curves that wait for values there.
template <class Steps>
struct WaypointOf {
    using Type = std::monostate;
};

template <class Steps>
requires requires {
    typename Steps::Waypoint;
}

struct WaypointOf<Steps> {
    using Type = typename Steps::Waypoint;
};

/// The place at which a curve waits; empty if it begins or continues from `curve.last`.
template <class Steps>
using WaitingAt = std::optional<typename WaypointOf<Steps>::Type>;

/// One curve on its way from `curve.last` until `until` (time since release, same sign as the duration), or
/// until values are missing: the curve is then as it was before the step that met them. Who has it attempts
/// the steps. Thread safety: disjoint curves may be advanced concurrently.
template <CurveSteps Steps, class Keep>
class CurveAdvance {
  public:
    enum class Next : std::uint8_t {
        Attempt, ///< a step of at most left()
        Done,
        Stopped ///< `stop` fired or `keep` returned false
    };

    /// @param steps  of this curve, in the direction of its duration
    /// @param keep   keep(step) is called with each step that was taken; false: the curve cannot go on
    /// @param place  where it waits, from one call to the next. Null: a curve that meets missing values is
    ///               good for nothing
    CurveAdvance(Steps steps,
                 Curve& curve,
                 const TraceOptions& options,
                 double until,
                 const std::stop_token& stop,
                 Keep keep,
                 WaitingAt<Steps>* place = nullptr)
        : steps_(std::move(steps)), curve_(curve), options_(options), until_(until), stop_(stop),
          keep_(std::move(keep)), place_(place) {}

    Steps& steps() { return steps_; }

    Curve& curve() const { return curve_; }

    double left() const { return left_; }

    Next begin() {
        const PointStatus status = [&] {
            if constexpr (can_wait)
                if (place_ != nullptr && *place_)
                    return steps_.resume(**place_);
            return steps_.begin(curve_);
        }();
        if (missed(steps_.field()))
            return Next::Done;
        if (status != PointStatus::Inside)
            curve_.end = end_at(status);
        return next();
    }

    /// Goes on after an attempt. @param step  it, where it was taken
    Next took(StepOutcome outcome, CurveStep& step) {
        ++curve_.attempts;
        if (missed(steps_.field()))
            return again();
        if (outcome == StepOutcome::Stagnation)
            curve_.end = end_at_rest(steps_.field(), curve_.last.position);
        if (outcome != StepOutcome::Taken)
            return next();
        step.time = curve_.last.time;
        // Before any other test: the steps of cells have their place there.
        carry_neighbourhood(steps_, curve_, step, options_);
        PointStatus met = PointStatus::Inside;
        const double theta = steps_.inside_until(step, met);
        if (missed(steps_.field())) {
            if (options_.stretch)
                curve_.stretches.pop_back();
            return again();
        }
        take_step(curve_, step, theta);
        if (!keep_(step))
            return Next::Stopped;
        if (theta < 1.0) {
            curve_.end = end_at(met);
            return next();
        }
        if (std::abs(step.dt) == left_)
            curve_.last.time = until_;
        const bool inside = steps_.arrive(curve_);
        if constexpr (can_wait)
            if (missed(steps_.field())) // whether it is inside is looked up again
                return wait_at(steps_.waypoint());
        if (!inside)
            curve_.end = CurveEnd::Domain;
        return next();
    }

  private:
    static constexpr bool can_wait = requires { typename Steps::Waypoint; };

    Next next() {
        if (curve_.end != CurveEnd::Running)
            return Next::Done;
        if ((curve_.attempts & 63u) == 0 && stop_.stop_requested())
            return Next::Stopped;
        left_ = std::abs(until_ - curve_.last.time);
        if (left_ <= 1e-12 * std::abs(curve_.duration)) {
            if (std::abs(until_) >= std::abs(curve_.duration) * (1.0 - 1e-12))
                curve_.end = CurveEnd::Time;
            return Next::Done;
        }
        if (curve_.attempts >= options_.most_steps) {
            curve_.end = CurveEnd::Budget;
            return Next::Done;
        }
        if constexpr (can_wait)
            if (place_ != nullptr)
                here_ = steps_.waypoint();
        next_dt_ = curve_.next_dt;
        // Memory is asked for where no brick is being read: those who hold bricks may have to give them up.
        return place_ != nullptr && !room_for_step(curve_, options_) ? wait_at(here_)
                                                                     : Next::Attempt;
    }

    /// The attempt does not count.
    Next again() {
        --curve_.attempts;
        curve_.next_dt = next_dt_;
        return wait_at(here_);
    }

    Next wait_at(const typename WaypointOf<Steps>::Type& here) {
        if (place_ != nullptr)
            *place_ = here;
        return Next::Done;
    }

    Steps steps_;
    Curve& curve_;
    const TraceOptions& options_;
    double until_;
    const std::stop_token& stop_;
    Keep keep_;
    WaitingAt<Steps>* place_;
    double left_ = 0.0;
    double next_dt_ = 0.0;                    ///< before the attempt
    typename WaypointOf<Steps>::Type here_{}; ///< where it set out to it
};

/// Advances a curve by itself. Returns false if it was stopped. The parameters are those of CurveAdvance.
template <CurveSteps Steps, class Keep>
bool advance_steps(Steps steps,
                   Curve& curve,
                   const TraceOptions& options,
                   double until,
                   const std::stop_token& stop,
                   const Keep& keep,
                   WaitingAt<Steps>* place = nullptr) {
    using Advance = CurveAdvance<Steps, Keep>;
    Advance advance(std::move(steps), curve, options, until, stop, keep, place);
    CurveStep step;
    typename Advance::Next next = advance.begin();
    while (next == Advance::Next::Attempt)
        next = advance.took(advance.steps().attempt(curve, advance.left(), step), step);
    return next != Advance::Next::Stopped;
}

/// The curve keeps its steps, or the options' watch sees them.
struct KeepInCurve {
    Curve& curve;
    const TraceOptions& options;

    /// Returns false where there is no memory.
    bool operator()(const CurveStep& step) const {
        if (options.watch == nullptr)
            return keep_step(curve, step, options);
        if (!(*options.watch)(curve, step))
            curve.end = CurveEnd::Time;
        return true;
    }
};

/// Puts a curve that has not been advanced yet where it begins.
inline void set_out(Curve& curve) {
    curve.last = {curve.seed, 0.0, 0.0, curve.seed_tangent};
}

/// Advances from where the curve ends, or its seed, and keeps the steps in it. Returns false also where there
/// is no memory.
template <CurveSteps Steps>
bool advance_curve(Steps steps,
                   Curve& curve,
                   const TraceOptions& options,
                   double until,
                   const std::stop_token& stop,
                   WaitingAt<Steps>* place = nullptr) {
    if (curve.attempts == 0 && (place == nullptr || !*place))
        set_out(curve);
    return advance_steps(std::move(steps), curve, options, until, stop, KeepInCurve{curve, options},
                         place);
}

} // namespace wakesurf::core
