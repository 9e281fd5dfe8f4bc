// The divergence of a field at a point: how fast the fluid expands there, and errors across a surface with it.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

/// Returns the trace of (grad v), which is given as a function of w, and may know it.
template <class Gradient>
double divergence_of(const Gradient& gradient) {
    if constexpr (requires { gradient.divergence(); })
        return gradient.divergence();
    else
        return gradient(Vec3(1.0, 0.0, 0.0)).x + gradient(Vec3(0.0, 1.0, 0.0)).y +
               gradient(Vec3(0.0, 0.0, 1.0)).z;
}

/// @param field  a VelocityField; those that know better have a divergence(p, t) of their own
template <class Field>
double divergence(const Field& field, const Vec3& p, double t) {
    if constexpr (requires { field.divergence(p, t); })
        return field.divergence(p, t);
    else
        return divergence_of([&](const Vec3& w) { return field.derivative(p, t, w); });
}

} // namespace wakesurf::core
