// Obstacle geometry for display: triangles, counter-clockwise as seen from the fluid.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wakesurf::core {

struct WallGeometry {
    std::vector<Vec3f> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

} // namespace wakesurf::core
