#include "core/integrate/curve.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

CurvePoint point_in(const Curve& curve, std::size_t index, double theta) {
    const CurveStep& step = curve.steps[index];
    const glm::dvec4 y = step.at(theta);
    const Vec3 next =
        index + 1 < curve.steps.size() ? curve.steps[index + 1].stretch : curve.last.stretch;
    return {Vec3(y), step.time + theta * step.dt, y.w, glm::mix(step.stretch, next, theta)};
}

/// theta at which the monotone arc length of a step reaches `arc`: Newton's iteration kept in a bracket.
double theta_at_arc(const CurveStep& step, double arc) {
    double low = 0.0;
    double high = 1.0;
    double theta =
        step.c[1].w != 0.0 ? std::clamp((arc - step.c[0].w) / step.c[1].w, 0.0, 1.0) : 0.5;
    for (int i = 0; i < 60; ++i) {
        const double miss = step.at(theta).w - arc;
        (miss > 0.0 ? high : low) = theta;
        if (std::abs(miss) <= 1e-14 * std::max(1.0, arc) || high - low < 1e-15)
            break;
        const double small = 1e-6;
        const double slope = (step.at(theta + small).w - step.at(theta - small).w) / (2.0 * small);
        const double newton = slope > 0.0 ? theta - miss / slope : -1.0;
        theta = newton > low && newton < high ? newton : 0.5 * (low + high);
    }
    return theta;
}

} // namespace

CurvePoint Curve::at_arc(double arc) const {
    if (steps.empty() || arc >= last.arc)
        return last;
    const auto after =
        std::upper_bound(steps.begin(), steps.end(), arc,
                         [](double a, const CurveStep& step) { return a < step.c[0].w; });
    const std::size_t index =
        after == steps.begin() ? 0 : static_cast<std::size_t>(after - steps.begin()) - 1;
    return point_in(*this, index, theta_at_arc(steps[index], std::max(arc, 0.0)));
}

CurvePoint Curve::at_time(double time) const {
    if (steps.empty() || std::abs(time) >= std::abs(last.time))
        return last;
    const auto after =
        std::upper_bound(steps.begin(), steps.end(), std::abs(time),
                         [](double t, const CurveStep& step) { return t < std::abs(step.time); });
    const std::size_t index =
        after == steps.begin() ? 0 : static_cast<std::size_t>(after - steps.begin()) - 1;
    const CurveStep& step = steps[index];
    return point_in(*this, index, std::clamp((time - step.time) / step.dt, 0.0, 1.0));
}

} // namespace wakesurf::core
