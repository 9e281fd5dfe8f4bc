// A point of a surface between its vertices: its place, and the surface's two coordinates there. Points add
// and scale, so that one formula interpolates all of it.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

struct PatchPoint {
    Vec3 position{0.0};
    double s = 0.0;
    double t = 0.0;
};

inline PatchPoint operator+(const PatchPoint& a, const PatchPoint& b) {
    return {a.position + b.position, a.s + b.s, a.t + b.t};
}

inline PatchPoint operator-(const PatchPoint& a, const PatchPoint& b) {
    return {a.position - b.position, a.s - b.s, a.t - b.t};
}

inline PatchPoint operator*(double k, const PatchPoint& a) {
    return {k * a.position, k * a.s, k * a.t};
}

} // namespace wakesurf::core
