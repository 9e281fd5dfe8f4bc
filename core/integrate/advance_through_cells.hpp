// Carries one particle like advance_curve, through a field that is a polynomial in each cell: one Taylor series a cell, which ends
// where the particle leaves it. Runge-Kutta steps across the faces of trilinear data are only of second order, and error control
// answers with steps a fraction of a cell; a series needs no trial steps, and its error is that of its last terms.
#pragma once

#include "core/integrate/advance_curve.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace wakesurf::core {

/// Position in units of the cell as a polynomial in time: the sum of term[k] t^k.
struct PathSeries {
    static constexpr std::size_t order = 5;
    std::array<std::array<double, 3>, order + 1> term;

    double at(std::size_t axis, double t) const {
        double sum = term[order][axis];
        for (std::size_t k = order; k-- > 0;)
            sum = sum * t + term[k][axis];
        return sum;
    }

    double slope(std::size_t axis, double t) const {
        double sum = order * term[order][axis];
        for (std::size_t k = order; k-- > 1;)
            sum = sum * t + static_cast<double>(k) * term[k][axis];
        return sum;
    }
};

template <class F>
concept CellwiseField = VelocityField<F> && requires(const F& field, const Vec3& p, double t) {
    { field.cells(1.0, true).series(p, t) } -> std::same_as<PathSeries>;
};

/// When and through which face a particle leaves its cell.
struct CellExit {
    double time = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    int step = 0; ///< of the cell's index; 0: not at all
};

/// By the path's first three terms, from the cell's inside.
inline CellExit roughly_leaves(const PathSeries& path, std::size_t axis) {
    const double direction = path.term[1][axis] < 0.0 ? -1.0 : 1.0;
    const double behind =
        std::max(direction > 0.0 ? path.term[0][axis] : 1.0 - path.term[0][axis], 0.0);
    const double ahead = std::max(1.0 - behind, 0.0);
    const double v = std::abs(path.term[1][axis]);
    const double a = direction * path.term[2][axis];
    const int step = direction > 0.0 ? +1 : -1;
    if (const double square = v * v + 4.0 * a * ahead; square >= 0.0) {
        const double sum = v + std::sqrt(square);
        return sum > 0.0 ? CellExit{2.0 * ahead / sum, axis, step} : CellExit{};
    }
    return {(v + std::sqrt(v * v - 4.0 * a * behind)) / (-2.0 * a), axis, -step}; // turns back
}

/// Newton's iteration from a rough exit. A particle that is d cells past the face when the next cell takes over is off by some
/// d * d of what the field's kink there turns it by, so 1e-5 is near enough except at the domain's border.
inline void sharpen(const PathSeries& path, CellExit& exit, double near_enough = 5e-3) {
    const double face = exit.step > 0 ? 1.0 : 0.0;
    for (int i = 0; i < 5; ++i) {
        const double slope = path.slope(exit.axis, exit.time);
        if (slope * exit.step <= 0.0)
            return;
        const double change = (path.at(exit.axis, exit.time) - face) / slope;
        exit.time = std::max(exit.time - change, 0.0);
        if (std::abs(change) <= near_enough * exit.time)
            return;
    }
}

inline CellExit leaves_cell(const PathSeries& path) {
    CellExit first;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const CellExit exit = roughly_leaves(path, axis); exit.time < first.time)
            first = exit;
    if (first.step == 0)
        return first;
    sharpen(path, first);
    constexpr double beyond = 1e-5; // of a cell
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double u = path.at(axis, first.time);
        if (axis == first.axis || (u <= 1.0 + beyond && u >= -beyond))
            continue;
        CellExit earlier{first.time, axis, u > 1.0 ? +1 : -1};
        sharpen(path, earlier);
        if (earlier.time < first.time)
            first = earlier;
    }
    return first;
}

/// Largest error of the series after time `t`, over t: what the dense output leaves out of the last term, and the term after it.
inline double series_error(const PathSeries& path, const Vec3& size, double t) {
    const auto square_of = [&](std::size_t k) {
        const Vec3 term = Vec3(path.term[k][0], path.term[k][1], path.term[k][2]) * size;
        return glm::dot(term, term);
    };
    const double last = std::sqrt(square_of(5));
    const double before = std::sqrt(std::max(square_of(4), std::sqrt(square_of(3)) * last));
    const double ratio = before > 0.0 ? last / before : 0.0;
    const double square = t * t;
    return last * square * square * (0.0025 + ratio * t);
}

/// True where the series is so good that its error need not be known: were each term as large as the one before.
inline bool surely_within(const PathSeries& path, const Vec3& size, double t, double allowed) {
    const Vec3 last = Vec3(path.term[5][0], path.term[5][1], path.term[5][2]) * size;
    const double power = t * t * t * t;
    return glm::dot(last, last) * power * power <= allowed * allowed;
}

/// The dense output of a series up to time `t`: its fifth power becomes the quartic that meets it at both ends and is elsewhere
/// nearest, within 0.0025 (Chebyshev).
inline CurveStep
dense_output(const PathSeries& path, const Vec3& lo, const Vec3& size, double arc, double t) {
    constexpr double quartic[5] = {0.0, -0.07725424859373686, 0.7317627457812106,
                                   -2.1545084971874737, 2.5};
    std::array<glm::dvec4, 5> m;
    double power = 1.0;
    const double t5 = t * t * t * t * t;
    const Vec3 last = Vec3(path.term[5][0], path.term[5][1], path.term[5][2]) * size * t5;
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec3 term = Vec3(path.term[k][0], path.term[k][1], path.term[k][2]) * size * power +
                          quartic[k] * last;
        m[k] = glm::dvec4(term, 0.0);
        power *= t;
    }
    CurveStep step;
    step.c[0] = m[0] + glm::dvec4(lo, arc);
    step.c[4] = m[4];
    step.c[3] = -m[3] - 2.0 * m[4];
    step.c[2] = -m[2] - m[3] - m[4];
    step.c[1] = m[1] - step.c[2];
    return step;
}

/// Arc length along a step by Simpson's rule, as a cubic with the speeds at both ends. Returns false where the speed falls
/// so much on the way that the cubic would not rise.
inline bool add_arc(CurveStep& step, double v0, double v_middle, double v1, double t) {
    const double length = t / 6.0 * (v0 + 4.0 * v_middle + v1);
    if (std::max(v0, v1) * t > 2.9 * length)
        return false;
    step.c[1].w = length;
    step.c[2].w = t * v0 - length;
    step.c[3].w = length - t * v1 - step.c[2].w;
    step.c[4].w = 0.0;
    return true;
}

/// The step along a series from its start, with dense output and without times. Shortens `t` until the series' error over it is allowed.
/// Nothing: the particle stands still.
/// @param lo, size  of the cell whose coordinates the series is in
inline std::optional<CurveStep> series_step(const PathSeries& path,
                                            const Vec3& lo,
                                            const Vec3& size,
                                            double arc,
                                            double allowed,
                                            double& t) {
    for (int i = 0; i < 20 && !surely_within(path, size, t, allowed); ++i) {
        const double error = series_error(path, size, t);
        if (error <= allowed)
            break;
        t *= std::clamp(0.9 * std::pow(allowed / error, 0.2), 0.1, 0.95);
    }
    const auto speed_at = [&](double time) {
        return glm::length(Vec3(path.slope(0, time), path.slope(1, time), path.slope(2, time)) *
                           size);
    };
    const double speed = speed_at(0.0);
    for (int i = 0; i <= 40; ++i, t *= 0.5) {
        CurveStep step = dense_output(path, lo, size, arc, t);
        if (add_arc(step, speed, speed_at(0.5 * t), speed_at(t), t))
            return step;
    }
    return std::nullopt;
}

/// As advance_curve with Dopri5; steps end at faces instead of after longest_step.
template <CellwiseField Field>
bool advance_through_cells(const Field& field,
                           Curve& curve,
                           const TraceOptions& options,
                           double until,
                           const std::stop_token& stop) {
    const double sign = curve.duration < 0.0 ? -1.0 : 1.0;
    if (curve.steps.empty()) {
        curve.last = {curve.seed, 0.0, 0.0, curve.seed_tangent};
        if (const PointStatus status = field.status(curve.seed); status != PointStatus::Inside)
            curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
    }
    auto cell = field.cells(sign, options.frozen);
    auto index = cell.index_of(curve.last.position);
    while (curve.end == CurveEnd::Running) {
        if ((curve.attempts & 63u) == 0 && stop.stop_requested())
            return false;
        const double left = std::abs(until - curve.last.time);
        if (left <= 1e-12 * std::abs(curve.duration)) {
            if (std::abs(until) >= std::abs(curve.duration) * (1.0 - 1e-12))
                curve.end = CurveEnd::Time;
            return true;
        }
        cell.enter(index);
        const Vec3 size = cell.size();
        const Vec3 inverse = cell.per_size();
        const double finest = cell.finest();
        const double now = curve.release + curve.last.time;
        const PathSeries path = cell.series((curve.last.position - cell.lo()) * inverse,
                                            options.frozen ? curve.release : now);
        ++curve.attempts;
        const Vec3 v0 = Vec3(path.term[1][0], path.term[1][1], path.term[1][2]) * size;
        const double speed = glm::length(v0);
        if (!(speed > options.stagnation_speed)) { // also ends on NaN
            curve.end = CurveEnd::Stagnation;
            return true;
        }
        CellExit exit = leaves_cell(path);
        auto next = index;
        next[exit.axis] += exit.step;
        if (!cell.inside(next))
            sharpen(path, exit, 1e-12);
        // A particle that grazes a face may cross it to and fro at once; it then goes on a little regardless.
        double t = std::max(exit.time, 1e-5 * finest / speed);
        if (!(t <= 1e3 * finest / speed)) // crawls round in its cell
            t = 1e3 * finest / speed;
        t = std::min(t, left);
        auto shortened =
            series_step(path, cell.lo(), size, curve.last.arc, options.tolerance * speed, t);
        if (!shortened) {
            curve.end = CurveEnd::Stagnation;
            return true;
        }
        CurveStep& step = *shortened;
        step.time = curve.last.time;
        step.dt = sign * t;
        step.stretch = curve.last.stretch;
        PointStatus status = PointStatus::Inside;
        const double theta =
            cell.obstacle() ? inside_until(field, step, options.longest_step, status) : 1.0;
        const glm::dvec4 end = step.at(theta);
        curve.last.position = Vec3(end);
        curve.last.arc = end.w;
        curve.last.time = t == left && theta == 1.0 ? until : step.time + theta * step.dt;
        if (options.stretch)
            curve.last.stretch = carry_stretch(
                field, step, options.frozen ? curve.release : now + 0.5 * step.dt, 0.05 * finest);
        if (!keep_step(curve, step, options))
            return false;
        if (theta < 1.0) {
            curve.end = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
        } else {
            if (t >= exit.time && exit.step != 0) {
                index[exit.axis] += exit.step;
            }
            for (std::size_t axis = 0; axis < 3; ++axis) { // beyond by what sharpen() let pass
                const int i = static_cast<int>(axis);
                const double u = (curve.last.position[i] - cell.lo()[i]) * inverse[i];
                if (axis != exit.axis || t < exit.time)
                    index[axis] += u > 1.0 ? 1 : u < 0.0 ? -1 : 0;
            }
            if (!cell.inside(index))
                curve.end = CurveEnd::Domain;
            else if (curve.attempts >= options.most_steps)
                curve.end = CurveEnd::Budget;
        }
    }
    return true;
}

} // namespace wakesurf::core
