// Curves given by formulas, without a field: for tests of what is built on curves.
#pragma once

#include "core/integrate/curve.hpp"

namespace wakesurf::tests {

/// Returns a straight curve from `a` to `b` at speed 1 in `pieces` steps.
inline core::Curve straight_curve(const core::Vec3& a, const core::Vec3& b, int pieces = 4) {
    core::Curve curve;
    curve.seed = a;
    const double length = glm::length(b - a);
    curve.duration = length;
    for (int i = 0; i < pieces; ++i) {
        core::CurveStep step;
        step.time = length * i / pieces;
        step.dt = length / pieces;
        step.c = {glm::dvec4(glm::mix(a, b, static_cast<double>(i) / pieces), step.time),
                  glm::dvec4((b - a) / static_cast<double>(pieces), step.dt)};
        curve.steps.push_back(step);
    }
    curve.last = {b, length, length, core::Vec3(0.0)};
    curve.end = core::CurveEnd::Time;
    return curve;
}

} // namespace wakesurf::tests
