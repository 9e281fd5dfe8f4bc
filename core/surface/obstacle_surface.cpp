#include "core/surface/obstacle_surface.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace wakesurf::core {

namespace {

using Index = std::array<std::uint32_t, 3>;

/// Node coordinates on each axis, whatever the grid.
using Axes = std::array<std::vector<double>, 3>;

/// Corners of the nodes' boxes: corner c of an axis lies midway between nodes c - 1 and c, clamped to the domain.
class Wall {
  public:
    explicit Wall(const Axes& axes) : axes_(axes) {}

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
        const std::uint64_t key =
            (std::uint64_t{corner[2]} * (axes_[1].size() + 1) + corner[1]) * (axes_[0].size() + 1) +
            corner[0];
        const auto [found, fresh] =
            ids_.try_emplace(key, static_cast<VertexId>(mesh.position.size()));
        if (fresh)
            mesh.position.push_back({between(corner, 0), between(corner, 1), between(corner, 2)});
        return found->second;
    }

    double between(const Index& corner, std::size_t axis) const {
        const auto& along = axes_[axis];
        const std::size_t c = corner[axis];
        return c == 0             ? along.front()
               : c < along.size() ? 0.5 * (along[c - 1] + along[c])
                                  : along.back();
    }

    const Axes& axes_;
    std::unordered_map<std::uint64_t, VertexId> ids_;
};

Axes axes_of(const UniformGrid& grid) {
    Axes axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < grid.dimensions[axis]; ++i)
            axes[axis].push_back(grid.origin[static_cast<int>(axis)] +
                                 i * grid.spacing[static_cast<int>(axis)]);
    return axes;
}

QuadComplex surface_over(const Axes& axes, const SolidMask& mask) {
    Wall wall(axes);
    if (mask.empty())
        return std::move(wall.mesh);
    const std::array<std::size_t, 3> n{axes[0].size(), axes[1].size(), axes[2].size()};
    const std::array<std::size_t, 3> stride{1, n[0], n[0] * n[1]};
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

} // namespace

QuadComplex obstacle_surface(const UniformGrid& grid, const SolidMask& mask) {
    return surface_over(axes_of(grid), mask);
}

QuadComplex obstacle_surface(const RectilinearGrid& grid, const SolidMask& mask) {
    return surface_over(grid.coordinates, mask);
}

QuadComplex obstacle_surface(const Grid& grid, const SolidMask& mask) {
    if (const auto* uniform = std::get_if<UniformGrid>(&grid))
        return obstacle_surface(*uniform, mask);
    if (const auto* rectilinear = std::get_if<RectilinearGrid>(&grid))
        return obstacle_surface(*rectilinear, mask);
    return {};
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
