// Lengths and angles of a moving surface's cells: what the refinement criteria look at.
#pragma once

#include "core/surface/moving/local_operations.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace wakesurf::core {

/// Squared lengths of a cell's sub-edges; roots are left to the few cells that need them.
struct SquaredLengths {
    std::array<double, 4> longest; ///< of each side
    double shortest;
};

inline SquaredLengths squared_lengths(const MovingMesh& mesh, const Cell& cell) {
    const auto& p = mesh.vertices.position;
    const auto between = [&](VertexId a, VertexId b) {
        const Vec3 edge = p[b] - p[a];
        return glm::dot(edge, edge);
    };
    SquaredLengths lengths{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t side = 0; side < 4; ++side) {
        const VertexId a = cell.corner[side];
        const VertexId b = cell.corner[(side + 1) % 4];
        const VertexId mid = cell.mid[side];
        const double first = between(a, mid == no_vertex ? b : mid);
        const double second = mid == no_vertex ? first : between(mid, b);
        // Written so that what is not a number stays.
        lengths.longest[side] = first > second ? first : second;
        lengths.shortest =
            lengths.shortest < std::min(first, second) ? lengths.shortest : std::min(first, second);
    }
    return lengths;
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
