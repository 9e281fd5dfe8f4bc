#include "core/integrate/curve.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

CurvePoint point_in(const Curve& curve, std::size_t index, double theta) {
    const CurveStep& step = curve.steps[index];
    const glm::dvec4 y = step.at(theta);
    const Vec3 stretch =
        index < curve.stretches.size() ? curve.stretches[index].at(theta) : curve.last.stretch;
    return {Vec3(y), step.time + theta * step.dt, y.w, stretch};
}

/// The ratio of the arc length to that at the start of the step, and its derivative, at theta.
struct ArcAt {
    double value, slope;
};

ArcAt arc_at(const CurveStep& step, double theta) {
    const double other = 1.0 - theta;
    const double c1 = step.c[1].w, c2 = step.c[2].w, c3 = step.c[3].w, c4 = step.c[4].w;
    const double inner = c3 + other * c4;
    const double middle = c2 + theta * inner;
    const double outer = c1 + other * middle;
    const double middle_slope = inner - theta * c4;
    return {theta * outer, outer + theta * (other * middle_slope - middle)};
}

/// Returns the theta at which the monotone arc length of a step reaches `arc`, by Newton's iteration kept in
/// a bracket.
double theta_at_arc(const CurveStep& step, double arc) {
    const double wanted = arc - step.c[0].w;
    double low = 0.0;
    double high = 1.0;
    double theta = step.c[1].w != 0.0 ? std::clamp(wanted / step.c[1].w, 0.0, 1.0) : 0.5;
    for (int i = 0; i < 60; ++i) {
        const ArcAt at = arc_at(step, theta);
        const double miss = at.value - wanted;
        (miss > 0.0 ? high : low) = theta;
        if (miss == 0.0 || high - low < 1e-15)
            break;
        const double newton = at.slope > 0.0 ? theta - miss / at.slope : -1.0;
        const bool near = newton >= low && newton <= high;
        theta = near ? newton : 0.5 * (low + high);
        if (near && std::abs(miss) <= 1e-7 * step.c[1].w)
            break; // the error squares: the next one would be below rounding
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
    return point_in(*this, index,
                    std::clamp((time - steps[index].time) / steps[index].dt, 0.0, 1.0));
}

void Curve::cut_last_step() {
    if (steps.empty())
        return;
    CurveStep& step = steps.back();
    const double part = (last.time - step.time) / step.dt;
    if (!(part > 1e-12)) {
        steps.pop_back();
        stretches.resize(std::min(stretches.size(), steps.size()));
        return;
    }
    // By powers of theta, and back.
    const auto& c = step.c;
    const double square = part * part;
    const glm::dvec4 first = part * (c[1] + c[2]);
    const glm::dvec4 second = square * (c[3] + c[4] - c[2]);
    const glm::dvec4 third = -part * square * (c[3] + 2.0 * c[4]);
    const glm::dvec4 c4 = square * square * c[4];
    const glm::dvec4 c3 = -third - 2.0 * c4;
    const glm::dvec4 c2 = c3 + c4 - second;
    step.c = {c[0], first - c2, c2, c3, c4};
    step.dt *= part;
    step.expansion *= static_cast<float>(part);
    if (stretches.size() == steps.size()) {
        StretchStep& stretch = stretches.back();
        const StretchStep whole = stretch;
        stretch.end = whole.at(part);
        stretch.start_change *= part;
        stretch.end_change = part * whole.change_at(part);
    }
}

CurvePoint CurveReader::at_arc(double arc) {
    const std::vector<CurveStep>& steps = curve_.steps;
    if (steps.empty() || arc >= curve_.last.arc)
        return curve_.last;
    while (step_ + 1 < steps.size() && steps[step_ + 1].c[0].w <= arc)
        ++step_;
    return point_in(curve_, step_, theta_at_arc(steps[step_], std::max(arc, 0.0)));
}

} // namespace wakesurf::core
