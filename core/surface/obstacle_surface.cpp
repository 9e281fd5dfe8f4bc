#include "core/surface/obstacle_surface.hpp"

#include <algorithm>
#include <unordered_map>

namespace wakesurf::core {

namespace {

using Index = std::array<std::uint32_t, 3>;

/// Corners of the nodes' boxes: corner c of an axis lies half a spacing before node c, clamped to the domain.
class Wall {
  public:
    explicit Wall(const UniformGrid& grid) : grid_(grid) {}

    /// The face of `node` towards the next node along `axis`, or towards the one before it.
    void add_face(const Index& node, int axis, bool towards_next, bool fluid_above) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Index corner = node;
        corner[static_cast<std::size_t>(axis)] += towards_next ? 1 : 0;
        const auto at = [&](std::uint32_t du, std::uint32_t dv) {
            Index c = corner;
            c[static_cast<std::size_t>(u)] += du;
            c[static_cast<std::size_t>(v)] += dv;
            return vertex(c);
        };
        Cell cell;
        cell.corner = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; // counter-clockwise seen from above
        if (!fluid_above)
            std::swap(cell.corner[1], cell.corner[3]);
        mesh.cells.push_back(cell);
    }

    QuadComplex mesh;

  private:
    VertexId vertex(const Index& corner) {
        const auto& n = grid_.dimensions;
        const std::uint64_t key =
            (std::uint64_t{corner[2]} * (n[1] + 1) + corner[1]) * (n[0] + 1) + corner[0];
        const auto [found, fresh] =
            ids_.try_emplace(key, static_cast<VertexId>(mesh.position.size()));
        if (fresh)
            mesh.position.push_back(grid_.origin + grid_.spacing * Vec3(clamped(corner, 0),
                                                                        clamped(corner, 1),
                                                                        clamped(corner, 2)));
        return found->second;
    }

    double clamped(const Index& corner, std::size_t axis) const {
        return std::clamp(corner[axis] - 0.5, 0.0, grid_.dimensions[axis] - 1.0);
    }

    const UniformGrid& grid_;
    std::unordered_map<std::uint64_t, VertexId> ids_;
};

} // namespace

QuadComplex obstacle_surface(const UniformGrid& grid, const SolidMask& mask) {
    Wall wall(grid);
    if (mask.empty())
        return std::move(wall.mesh);
    const auto& n = grid.dimensions;
    const std::array<std::size_t, 3> stride{1, n[0], std::size_t{n[0]} * n[1]};
    std::size_t node = 0;
    for (std::uint32_t k = 0; k < n[2]; ++k)
        for (std::uint32_t j = 0; j < n[1]; ++j)
            for (std::uint32_t i = 0; i < n[0]; ++i, ++node) {
                const Index index{i, j, k};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const bool here = mask.fluid[node] != 0;
                    const bool above =
                        index[axis] + 1 == n[axis] || mask.fluid[node + stride[axis]] != 0;
                    if (index[axis] == 0 && !here)
                        wall.add_face(index, static_cast<int>(axis), false, false);
                    if (here != above)
                        wall.add_face(index, static_cast<int>(axis), true, above);
                }
            }
    return std::move(wall.mesh);
}

QuadComplex wall_surface(const WallGeometry& walls) {
    QuadComplex surface;
    for (const Vec3f& point : walls.points)
        surface.position.emplace_back(point);
    for (const auto& [a, b, c] : walls.triangles)
        surface.cells.push_back({{a, b, c, c}, Cell{}.mid});
    return surface;
}

} // namespace wakesurf::core
