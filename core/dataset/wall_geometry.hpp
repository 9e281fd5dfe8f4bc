// Obstacle geometry for display: triangles, of built-in bodies counter-clockwise as seen from the fluid, of stored walls in the
// order that their source has.
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
