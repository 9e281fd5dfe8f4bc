#include "core/surface/family/plane_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

// A step is no longer than a cell, in which the flow hardly turns: a passage there and back within an eighth
// of it is none.
constexpr int looks = 8;

/// The height over a plane along a step, with the coefficients of its dense output.
struct HeightAlong {
    std::array<double, 5> c;

    HeightAlong(const SourcePlane& plane, const CurveStep& step) : c{} {
        for (std::size_t k = 0; k < c.size(); ++k)
            c[k] = glm::dot(plane.normal, Vec3(step.c[k]));
        c[0] = plane.height(Vec3(step.c[0]));
    }

    double at(double theta) const {
        const double other = 1.0 - theta;
        return c[0] + theta * (c[1] + other * (c[2] + theta * (c[3] + other * c[4])));
    }

    /// Returns where it is 0 between two places with different signs.
    double root(double low, double high) const {
        const bool rising = at(low) < at(high);
        for (int halving = 0; halving < 60 && low < high; ++halving) {
            const double middle = 0.5 * (low + high);
            if (middle == low || middle == high)
                break;
            ((at(middle) < 0.0) == rising ? low : high) = middle;
        }
        return high;
    }
};

} // namespace

void PlanePassages::pass(const Vec3& at, bool rising, double sign) {
    auto& kind = rising == (sign > 0.0) ? main : other;
    if (!kind)
        kind = at;
}

bool PlanePassages::look(const SourcePlane& plane,
                         const Curve& curve,
                         const CurveStep& step,
                         double sign) {
    const double begin = plane.height(Vec3(step.c[0]));
    const double way = curve.last.arc - step.c[0].w;
    const double end = step.dt != 0.0 ? (curve.last.time - step.time) / step.dt : 0.0;
    const HeightAlong height(plane, step);
    if (side_ == 0) {
        // A node on the plane, but for rounding, is where it is passed.
        const double rounded =
            1e-12 * (glm::length(plane.point) + glm::length(Vec3(step.c[0])) + step.c[1].w);
        const double slope = height.c[1] + height.c[2];
        side_ = begin > 0.0 ? 1 : -1;
        if (std::abs(begin) <= rounded && slope != 0.0) {
            side_ = slope > 0.0 ? 1 : -1;
            pass(Vec3(step.c[0]), slope > 0.0, sign);
        }
    }
    if (std::abs(begin) > 1.01 * way) // too far away
        return !main;
    double before = 0.0;
    for (int i = 1; i <= looks && !main; ++i) {
        const double theta = end * i / looks;
        if (height.at(theta) * side_ < 0.0) {
            pass(Vec3(step.at(height.root(before, theta))), side_ < 0, sign);
            side_ = -side_;
        }
        before = theta;
    }
    return !main;
}

void PlanePassages::end(const SourcePlane& plane, const Curve& curve, double sign, double slack) {
    if (side_ != 0 && std::abs(plane.height(curve.last.position)) <= slack)
        pass(curve.last.position, side_ < 0, sign);
}

} // namespace wakesurf::core
