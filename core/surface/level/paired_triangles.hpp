// Triangles as cells of a quad complex: neighbours become one quad wherever that is convex and nearly flat,
// and a triangle that is left over gets a vertex in the middle of its longest side, which hangs on the cell
// beyond. The surface stays the same, without cracks.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Appends a vertex to `points` for each triangle that is left over, one for two that share their longest
/// side. REQUIRES: indices below the number of points; no triangle repeats one; a directed edge is used once.
/// Cost: O(triangles). The same triangles give the same cells.
std::vector<Cell> paired_triangles(std::vector<Vec3>& points,
                                   std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace wakesurf::core
