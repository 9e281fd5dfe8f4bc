#include "core/field/cells/cell_sampler.hpp"

#include "core/integrate/advance_curve.hpp"

#include <algorithm>

namespace wakesurf::core {

bool advance_through_cells(const CellSampler& sampler,
                           Curve& curve,
                           const TraceOptions& options,
                           double until,
                           const std::stop_token& stop) {
    const double sign = curve.duration < 0.0 ? -1.0 : 1.0;
    const auto field = sampler.cursor();
    if (curve.steps.empty())
        curve.last = {curve.seed, 0.0, 0.0, curve.seed_tangent};
    if (const PointStatus status = field.status(curve.last.position);
        status != PointStatus::Inside) {
        curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
        return true;
    }
    const Vec3 unit(1.0);
    while (curve.end == CurveEnd::Running) {
        if ((curve.attempts & 63u) == 0 && stop.stop_requested())
            return false;
        const double left = std::abs(until - curve.last.time);
        if (left <= 1e-12 * std::abs(curve.duration)) {
            if (std::abs(until) >= std::abs(curve.duration) * (1.0 - 1e-12))
                curve.end = CurveEnd::Time;
            return true;
        }
        const double now = curve.release + curve.last.time;
        const double field_time = options.frozen ? curve.release : now;
        const auto [space, local] =
            field.path(curve.last.position, field_time, sign, options.frozen);
        ++curve.attempts;
        const auto vector = [](const std::array<double, 3>& term) {
            return Vec3(term[0], term[1], term[2]);
        };
        const double speed = glm::length(vector(space.term[1]));
        if (!(speed > options.stagnation_speed)) { // also ends on NaN
            curve.end = CurveEnd::Stagnation;
            return true;
        }
        const Vec3 pace = glm::abs(vector(local.term[1]));
        const double crossing = 1.0 / std::max(std::max(pace.x, pace.y), pace.z);
        // A particle that grazes a face may cross it to and fro at once; it then goes on a little regardless. One that
        // circles in its cell does not do so for ever.
        const double exit = leaves_cell(field.place().geometry().shape(), local);
        double t = std::min(std::min(std::max(exit, 1e-5 * crossing), 1e3 * crossing), left);
        auto shortened =
            series_step(space, Vec3(0.0), unit, curve.last.arc, options.tolerance * speed, t);
        if (!shortened) {
            curve.end = CurveEnd::Stagnation;
            return true;
        }
        CurveStep& step = *shortened;
        step.time = curve.last.time;
        step.dt = sign * t;
        step.stretch = curve.last.stretch;
        PointStatus status = PointStatus::Inside;
        const double theta = field.status(Vec3(step.at(1.0))) == PointStatus::Inside
                                 ? 1.0
                                 : inside_until(field, step, options.longest_step, status);
        const glm::dvec4 end = step.at(theta);
        curve.last.position = Vec3(end);
        curve.last.arc = end.w;
        curve.last.time = t == left && theta == 1.0 ? until : step.time + theta * step.dt;
        if (options.stretch)
            curve.last.stretch =
                carry_stretch(field, step, options.frozen ? curve.release : now + 0.5 * step.dt,
                              0.05 * options.longest_step);
        if (!keep_step(curve, step, options))
            return false;
        if (theta < 1.0)
            curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
        else if (curve.attempts >= options.most_steps)
            curve.end = CurveEnd::Budget;
    }
    return true;
}

} // namespace wakesurf::core
