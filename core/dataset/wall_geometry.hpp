// Obstacle geometry for display: triangles, of built-in bodies counter-clockwise as seen from the fluid, of
// stored walls in the order that their source has.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// A body as triangles.
struct WallGeometry {
    std::vector<Vec3f> points;                           ///< corners of the triangles
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< numbers of three points each
};

} // namespace wakesurf::core
