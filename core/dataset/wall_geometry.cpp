#include "core/dataset/wall_geometry.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::core {

std::size_t body_triangles(const std::vector<BoundaryPatch>& patches, std::size_t all) {
    if (patches.empty())
        return all;
    std::size_t count = 0;
    for (const BoundaryPatch& patch : patches)
        count += patch.kind == BoundaryPatch::Kind::Wall ? patch.triangles : 0;
    return std::min(count, all);
}

WallGeometry body_of(WallGeometry walls) {
    walls.triangles.resize(body_triangles(walls.patches, walls.triangles.size()));
    std::erase_if(walls.patches, [](const BoundaryPatch& patch) {
        return patch.kind != BoundaryPatch::Kind::Wall;
    });
    std::size_t points = 0;
    for (const auto& triangle : walls.triangles)
        points = std::max(points, std::size_t{1} + *std::ranges::max_element(triangle));
    walls.points.resize(points);
    return walls;
}

} // namespace wakesurf::core
