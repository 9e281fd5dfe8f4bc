// A particle of a moving surface: its position and two tangents of the surface there, w' = (grad v) w. The
// tangents give cubic interpolation between particles, normals and deformation, and with how much the fluid
// expands the growth of errors. Source: Schneider, Wiebel,
// Scheuermann, Smooth Stream Surfaces of Fourth Order Precision, EuroVis 2009 (one tangent, stream surfaces).
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

struct Carried {
    Vec3 position{0.0};
    Vec3 along_s{0.0};
    Vec3 along_t{0.0};
    double expansion =
        0.0; ///< logarithm of the volume that a unit of it at release has: div v over time
};

inline Carried operator+(const Carried& a, const Carried& b) {
    return {a.position + b.position, a.along_s + b.along_s, a.along_t + b.along_t,
            a.expansion + b.expansion};
}

inline Carried operator-(const Carried& a, const Carried& b) {
    return {a.position - b.position, a.along_s - b.along_s, a.along_t - b.along_t,
            a.expansion - b.expansion};
}

inline Carried operator*(double k, const Carried& a) {
    return {k * a.position, k * a.along_s, k * a.along_t, k * a.expansion};
}

} // namespace wakesurf::core
