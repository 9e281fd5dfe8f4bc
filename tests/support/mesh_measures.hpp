// Measures of a quad complex that tests compare with what geometry demands.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Counts how often cells use each undirected sub-edge.
inline std::map<std::pair<core::VertexId, core::VertexId>, int>
edge_uses(const core::QuadComplex& mesh) {
    std::map<std::pair<core::VertexId, core::VertexId>, int> uses;
    for (const core::Cell& cell : mesh.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const auto a = outline.vertex[i];
            const auto b = outline.vertex[(i + 1) % outline.count];
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
    }
    return uses;
}

/// Returns V - E + F: 1 for a sheet without holes, 0 for a tube.
inline std::int64_t euler_characteristic(const core::QuadComplex& mesh) {
    return static_cast<std::int64_t>(mesh.vertices()) -
           static_cast<std::int64_t>(edge_uses(mesh).size()) +
           static_cast<std::int64_t>(mesh.cells.size());
}

/// Returns the number of closed curves of the boundary.
inline int boundary_loops(const core::QuadComplex& mesh) {
    std::map<core::VertexId, core::VertexId> parent;
    const auto root = [&](core::VertexId v) {
        parent.try_emplace(v, v);
        while (parent[v] != v)
            v = parent[v];
        return v;
    };
    for (const auto& [edge, uses] : edge_uses(mesh))
        if (uses == 1) {
            const auto a = root(edge.first);
            const auto b = root(edge.second);
            parent[a] = b;
        }
    int loops = 0;
    for (const auto& [v, up] : parent)
        loops += v == up;
    return loops;
}

/// Returns the smallest angle at a cell's corners, in degrees.
inline double smallest_angle(const core::QuadComplex& mesh, const core::Cell& cell) {
    double smallest = 180.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const core::Vec3& here = mesh.position[cell.corner[i]];
        const core::Vec3 a = mesh.position[cell.corner[(i + 1) % 4]] - here;
        const core::Vec3 b = mesh.position[cell.corner[(i + 3) % 4]] - here;
        smallest = std::min(smallest, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) *
                                          180.0 / std::numbers::pi);
    }
    return smallest;
}

/// Returns the median of all cells' smallest angles, in degrees.
inline double median_smallest_angle(const core::QuadComplex& mesh) {
    std::vector<double> angles;
    for (const core::Cell& cell : mesh.cells)
        angles.push_back(smallest_angle(mesh, cell));
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return *middle;
}

/// Returns the sum of cell areas, each cell as a fan from its centre.
inline double area(const core::QuadComplex& mesh) {
    double sum = 0.0;
    for (const core::Cell& cell : mesh.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        core::Vec3 centre(0.0);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            centre += mesh.position[outline.vertex[i]] / static_cast<double>(outline.count);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            sum += 0.5 * glm::length(glm::cross(
                             mesh.position[outline.vertex[i]] - centre,
                             mesh.position[outline.vertex[(i + 1) % outline.count]] - centre));
    }
    return sum;
}

} // namespace wakesurf::tests
