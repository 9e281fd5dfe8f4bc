// Numbers and vectors that carry their derivatives along x, y and z with them: a formula of places that is
// written once gives its value, or also its exact gradient (forward differentiation).
#pragma once

#include "core/base/vec3.hpp"

#include <array>

namespace wakesurf::core {

struct Dual {
    double value = 0.0;
    Vec3 slope{0.0};

    friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.value + b.value, a.slope + b.slope};
    }

    friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.value - b.value, a.slope - b.slope};
    }

    friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.value * b.value, a.value * b.slope + b.value * a.slope};
    }

    friend Dual operator*(double k, const Dual& a) { return {k * a.value, k * a.slope}; }

    friend Dual operator/(const Dual& a, const Dual& b) {
        const double ratio = a.value / b.value;
        return {ratio, (a.slope - ratio * b.slope) / b.value};
    }
};

struct DualVec3 {
    Vec3 value{0.0};
    std::array<Vec3, 3> slope{Vec3(0.0), Vec3(0.0), Vec3(0.0)}; ///< along x, y and z

    /// Returns a place as a function of itself.
    static DualVec3 place(const Vec3& p) {
        return {p, {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}};
    }

    /// Returns the change along a vector.
    Vec3 along(const Vec3& w) const { return w.x * slope[0] + w.y * slope[1] + w.z * slope[2]; }

    friend DualVec3 operator+(const DualVec3& a, const DualVec3& b) {
        return {a.value + b.value,
                {a.slope[0] + b.slope[0], a.slope[1] + b.slope[1], a.slope[2] + b.slope[2]}};
    }

    friend DualVec3 operator-(const DualVec3& a, const DualVec3& b) { return a + -1.0 * b; }

    friend DualVec3 operator*(double k, const DualVec3& a) {
        return {k * a.value, {k * a.slope[0], k * a.slope[1], k * a.slope[2]}};
    }

    friend DualVec3 operator*(const Dual& k, const DualVec3& a) {
        const auto along = [&](int axis) {
            return k.value * a.slope[static_cast<std::size_t>(axis)] + k.slope[axis] * a.value;
        };
        return {k.value * a.value, {along(0), along(1), along(2)}};
    }

    friend Dual dot(const DualVec3& a, const DualVec3& b) {
        const auto along = [&](std::size_t axis) {
            return glm::dot(a.slope[axis], b.value) + glm::dot(a.value, b.slope[axis]);
        };
        return {glm::dot(a.value, b.value), Vec3(along(0), along(1), along(2))};
    }
};

// The same formula for numbers without derivatives.

inline double real_part(double a) {
    return a;
}

inline double real_part(const Dual& a) {
    return a.value;
}

inline const Vec3& real_part(const Vec3& a) {
    return a;
}

inline const Vec3& real_part(const DualVec3& a) {
    return a.value;
}

inline double component(const Vec3& a, int axis) {
    return a[axis];
}

inline Dual component(const DualVec3& a, int axis) {
    return {a.value[axis], Vec3(a.slope[0][axis], a.slope[1][axis], a.slope[2][axis])};
}

inline void set_component(Vec3& a, int axis, double to) {
    a[axis] = to;
}

inline void set_component(DualVec3& a, int axis, const Dual& to) {
    a.value[axis] = to.value;
    for (int along = 0; along < 3; ++along)
        a.slope[static_cast<std::size_t>(along)][axis] = to.slope[along];
}

} // namespace wakesurf::core
