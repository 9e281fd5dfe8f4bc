// A field that is a polynomial in each cell, and a particle's way through it by one Taylor series a cell: no step goes across a face,
// where the field has a kink and Runge-Kutta steps of any order are of second.
#pragma once

#include "core/integrate/advance_curve.hpp"
#include "core/integrate/advance_particle.hpp"

#include <cstddef>
#include <limits>

namespace wakesurf::core {

/// Its curves and particles go cell by cell, unless RK4 is asked for.
template <class Field>
concept FieldInSeries = requires {
    &Field::series_steps;
};

/// A tangent carried along a step, w' = (grad v) w by the midpoint rule over either half.
template <CarryingField Field>
Vec3 carry_tangent(const Field& field, const CurveStep& step, double start, const Vec3& tangent) {
    Vec3 w = tangent;
    const double half = 0.5 * step.dt;
    for (const double middle : {0.25, 0.75}) {
        const Vec3 p(step.at(middle));
        const double t = start + step.time + middle * step.dt;
        w += half * field.derivative(p, t, w + 0.5 * half * field.derivative(p, t, w));
    }
    return w;
}

/// As advance_particle with Method::Dopri5.
/// @param field  whose series are taken
/// @param view   the same field, for the tangents' slopes
template <FieldInSeries Field, CarryingField View>
void advance_in_series(const Field& field,
                       const View& view,
                       ParticleState& at,
                       double to,
                       const AdvanceOptions& options,
                       bool tangents) {
    if (to == at.time || at.end != CurveEnd::Running)
        return;
    TraceOptions trace;
    trace.tolerance = options.tolerance;
    trace.longest_step = options.longest_step;
    trace.stagnation_speed = options.stagnation_speed;
    trace.most_steps = std::numeric_limits<std::size_t>::max();
    Curve way;
    way.seed = at.carried.position;
    way.release = at.time;
    way.duration = to - at.time;
    (void)advance_curve(field.series_steps(trace, way.duration < 0.0 ? -1.0 : 1.0), way, trace,
                        way.duration, {});
    at.carried.position = way.last.position;
    const bool arrived = way.end == CurveEnd::Time;
    at.time = arrived ? to : way.release + way.last.time;
    at.end = arrived ? CurveEnd::Running : way.end;
    if (!tangents)
        return;
    for (const CurveStep& step : way.steps) {
        at.carried.along_s = carry_tangent(view, step, way.release, at.carried.along_s);
        at.carried.along_t = carry_tangent(view, step, way.release, at.carried.along_t);
    }
}

} // namespace wakesurf::core
