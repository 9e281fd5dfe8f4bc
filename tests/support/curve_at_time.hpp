// The point of a curve at a time, for tests that compare curves with formulas and with each other. Surfaces
// take theirs by arc length.
#pragma once

#include "core/integrate/curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wakesurf::tests {

/// Returns the point at a time since release, between 0 and that of the curve's end; its stretch is that at
/// the end of the curve.
inline core::CurvePoint at_time(const core::Curve& curve, double time) {
    if (curve.steps.empty() || std::abs(time) >= std::abs(curve.last.time))
        return curve.last;
    const auto after = std::upper_bound(
        curve.steps.begin(), curve.steps.end(), std::abs(time),
        [](double t, const core::CurveStep& step) { return t < std::abs(step.time); });
    const core::CurveStep& step =
        after == curve.steps.begin() ? curve.steps.front() : *std::prev(after);
    const double theta = std::clamp((time - step.time) / step.dt, 0.0, 1.0);
    const glm::dvec4 y = step.at(theta);
    return {core::Vec3(y), step.time + theta * step.dt, y.w, curve.last.stretch};
}

} // namespace wakesurf::tests
