// Points and velocities: GLM vectors, double for the engine and float for stored fields.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace wakesurf::core {

using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;

inline bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace wakesurf::core
