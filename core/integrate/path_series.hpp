// A particle's path through a cell in which the field is a polynomial, as a Taylor series in time, and the
// step along it. Runge-Kutta steps across the faces of such data are only of second order, and error control
// answers with steps a fraction of a cell; a series needs no trial steps, and its error is that of its last
// terms. Source: Hairer, Norsett, Wanner, Solving ODEs I, I.8.
#pragma once

#include "core/integrate/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wakesurf::core {

/// The position in units of the cell as a polynomial in time: the sum of term[k] t^k.
template <std::size_t Order>
struct PathSeriesOf {
    static constexpr std::size_t order = Order;
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

    /// Returns a term in the units of space, of a cell that has this size.
    Vec3 sized(std::size_t k, const Vec3& size) const {
        return Vec3(term[k][0], term[k][1], term[k][2]) * size;
    }
};

/// The series that has dense output.
using PathSeries = PathSeriesOf<5>;

/// Returns the largest error of the series after time `t`, over t: what the dense output leaves out of the
/// last term, and the term after it.
inline double series_error(const PathSeries& path, const Vec3& size, double t) {
    const auto square_of = [&](std::size_t k) {
        const Vec3 term = path.sized(k, size);
        return glm::dot(term, term);
    };
    const double last = std::sqrt(square_of(5));
    const double before = std::sqrt(std::max(square_of(4), std::sqrt(square_of(3)) * last));
    const double ratio = before > 0.0 ? last / before : 0.0;
    const double square = t * t;
    return last * square * square * (0.0025 + ratio * t);
}

/// Returns how far the series' end after time `t` may be off by the terms after the last one. One that
/// happens to be small says nothing of the next, so they grow as fast as any of the last three did.
template <std::size_t Order>
double end_error(const PathSeriesOf<Order>& path, const Vec3& size, double t) {
    const auto length_of = [&](std::size_t k) { return glm::length(path.sized(k, size)); };
    const double last = length_of(Order);
    const double before = std::max(length_of(Order - 1), std::sqrt(length_of(Order - 2) * last));
    const double earlier = std::max(length_of(Order - 2), std::sqrt(length_of(Order - 3) * before));
    if (!(earlier > 0.0 && before > 0.0))
        return 0.0;
    const double growth = t * std::max(last / before, before / earlier);
    double power = t;
    for (std::size_t k = 2; k < Order; ++k)
        power *= t;
    return growth * std::max(last * t, before * growth) * power / std::max(1.0 - growth, 0.1);
}

/// True where the series is so good that its error need not be known: were each term as large as the one
/// before.
inline bool surely_within(const PathSeries& path, const Vec3& size, double t, double allowed) {
    const Vec3 last = path.sized(5, size);
    const double power = t * t * t * t;
    return glm::dot(last, last) * power * power <= allowed * allowed;
}

/// Returns the dense output of a series up to time `t`: its fifth power becomes the quartic that meets it at
/// both ends and is elsewhere nearest, within 0.0025 (Chebyshev).
inline CurveStep
dense_output(const PathSeries& path, const Vec3& lo, const Vec3& size, double arc, double t) {
    constexpr double quartic[5] = {0.0, -0.07725424859373686, 0.7317627457812106,
                                   -2.1545084971874737, 2.5};
    std::array<glm::dvec4, 5> m;
    double power = 1.0;
    const double t5 = t * t * t * t * t;
    const Vec3 last = path.sized(5, size) * t5;
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec3 term = path.sized(k, size) * power + quartic[k] * last;
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

/// Arc length along a step by Simpson's rule, as a cubic with the speeds at both ends. Returns false where
/// the speed falls so much on the way that the cubic would not rise.
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

/// Returns the error that a series may have, over the time it serves for. A particle that starts from rest goes a
/// way that is not known yet: a twentieth of the longest step, as Runge-Kutta steps allow.
inline double allowed_error(const TraceOptions& options, bool rests, double speed, double left) {
    return options.tolerance *
           (rests ? std::max(speed, 0.05 * options.longest_step / left) : speed);
}

/// Returns the step along a series from its start, with dense output and without times. It shortens `t` until
/// the series' error over it is allowed. Nothing is returned where the particle stands still.
/// @param lo, size  of the cell whose coordinates the series is in
/// @param least  `t` is not shortened below this for an error, which the step then states
inline std::optional<CurveStep> series_step(const PathSeries& path,
                                            const Vec3& lo,
                                            const Vec3& size,
                                            double arc,
                                            double allowed,
                                            double& t,
                                            double least) {
    for (int i = 0; i < 20 && t > least && !surely_within(path, size, t, allowed); ++i) {
        const double error = series_error(path, size, t);
        if (error <= allowed)
            break;
        t = std::max(t * std::clamp(0.9 * std::pow(allowed / error, 0.2), 0.1, 0.95), least);
    }
    const auto speed_at = [&](double time) {
        return glm::length(Vec3(path.slope(0, time), path.slope(1, time), path.slope(2, time)) *
                           size);
    };
    const double speed = speed_at(0.0);
    for (int i = 0; i <= 40; ++i, t *= 0.5) {
        CurveStep step = dense_output(path, lo, size, arc, t);
        if (!add_arc(step, speed, speed_at(0.5 * t), speed_at(t), t))
            continue;
        step.error = static_cast<float>(end_error(path, size, t));
        return step;
    }
    return std::nullopt;
}

} // namespace wakesurf::core
