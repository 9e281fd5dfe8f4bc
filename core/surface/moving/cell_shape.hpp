// Lengths and angles of a moving surface's cells: what the refinement criteria look at.
#pragma once

#include "core/surface/moving/local_operations.hpp"

#include <algorithm>
#include <array>

namespace wakesurf::core {

/// Longest sub-edge of each side.
inline std::array<double, 4> longest_of_sides(const MovingMesh& mesh, const Cell& cell) {
    std::array<double, 4> longest;
    for (std::size_t side = 0; side < 4; ++side) {
        const VertexId a = cell.corner[side];
        const VertexId b = cell.corner[(side + 1) % 4];
        const VertexId mid = cell.mid[side];
        longest[side] = mid == no_vertex
                            ? mesh.edge_length(a, b)
                            : std::max(mesh.edge_length(a, mid), mesh.edge_length(mid, b));
    }
    return longest;
}

/// Normal of a cell by its diagonals, of unit length; zero for a cell without area.
inline Vec3f normal(const MovingMesh& mesh, const Cell& cell) {
    const auto& p = mesh.vertices.position;
    const Vec3 area =
        glm::cross(p[cell.corner[2]] - p[cell.corner[0]], p[cell.corner[3]] - p[cell.corner[1]]);
    const double length = glm::length(area);
    return length > 0.0 ? Vec3f(area / length) : Vec3f(0.0f);
}

template <class Visit>
void for_each_vertex(const Cell& cell, Visit visit) {
    for (std::size_t k = 0; k < 4; ++k) {
        visit(cell.corner[k]);
        if (cell.mid[k] != no_vertex)
            visit(cell.mid[k]);
    }
}

} // namespace wakesurf::core
