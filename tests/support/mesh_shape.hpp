// The shape of a surface's mesh: thin cells, small angles, specks and holes. Cells are measured as polygons:
// neither a hanging node nor a straight corner of the outline counts as a corner.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "tests/support/mesh_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace wakesurf::tests {

/// A cell's outline in space.
struct CellOutline {
    std::array<core::Vec3, 8> point;
    std::array<bool, 8> corner; ///< not a hanging node
    std::uint32_t count = 0;
    core::Vec3 area{0.0}; ///< along the normal, as long as the area is large

    CellOutline(const core::QuadComplex& mesh, const core::Cell& cell) {
        for (std::size_t side = 0; side < 4; ++side)
            for (const core::VertexId v : {cell.corner[side], cell.mid[side]})
                if (v != core::no_vertex) {
                    corner[count] = v == cell.corner[side];
                    point[count++] = mesh.position[v];
                }
        for (std::uint32_t i = 0; i < count; ++i)
            area += 0.5 * glm::cross(point[i] - point[0], next(i) - point[0]);
    }

    const core::Vec3& next(std::uint32_t i) const { return point[(i + 1) % count]; }

    const core::Vec3& before(std::uint32_t i) const { return point[(i + count - 1) % count]; }

    /// Returns the angle between the edges at a point, inside, in degrees from 0 to 360.
    double angle(std::uint32_t i) const {
        const core::Vec3 to = next(i) - point[i], from = before(i) - point[i];
        const core::Vec3 across = glm::cross(to, from);
        const double angle =
            std::atan2(glm::length(across), glm::dot(to, from)) * 180.0 / std::numbers::pi;
        return glm::dot(across, area) < 0.0 ? 360.0 - angle : angle;
    }

    /// Says whether the outline turns visibly at a point.
    bool turns(std::uint32_t i) const {
        constexpr double straight = 3.0; // degrees
        return corner[i] && std::abs(angle(i) - 180.0) > straight;
    }
};

/// Returns the smallest angle of the corners, in degrees; 0 if two of them are at one place.
inline double smallest_corner(const CellOutline& outline) {
    double smallest = 180.0;
    for (std::uint32_t i = 0; i < outline.count; ++i)
        if (outline.turns(i))
            smallest = std::min(smallest, outline.angle(i));
    return smallest == 180.0 ? 0.0 : smallest;
}

/// Returns the longest side squared over area, a side being all between two corners; 1 for a square.
inline double slenderness(const CellOutline& outline) {
    std::vector<core::Vec3> corners;
    for (std::uint32_t i = 0; i < outline.count; ++i)
        if (outline.turns(i))
            corners.push_back(outline.point[i]);
    double longest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const core::Vec3 side = corners[i] - corners[(i + 1) % corners.size()];
        longest = std::max(longest, glm::dot(side, side));
    }
    const double area = glm::length(outline.area);
    return corners.size() > 2 && area > 0.0 ? longest / area
                                            : std::numeric_limits<double>::infinity();
}

inline constexpr double most_slender = 20.0; ///< what exceeds it is a sliver

/// Returns the width of the narrowest strip between two parallels that the cell fits into.
inline double narrowest_width(const CellOutline& outline) {
    const double area = glm::length(outline.area);
    if (!(area > 0.0))
        return 0.0;
    double narrowest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < outline.count; ++i)
        for (std::uint32_t k = 0; k < outline.count; ++k) {
            const core::Vec3 along = outline.point[k] - outline.point[i];
            if (!(glm::length(along) > 0.0))
                continue;
            const core::Vec3 across = glm::cross(outline.area / area, glm::normalize(along));
            double least = 0.0, most = 0.0;
            for (std::uint32_t j = 0; j < outline.count; ++j) {
                const double off = glm::dot(outline.point[j] - outline.point[i], across);
                least = std::min(least, off);
                most = std::max(most, off);
            }
            narrowest = std::min(narrowest, most - least);
        }
    return narrowest;
}

struct MeshShape {
    std::size_t quads = 0;
    double slivers = 0.0; ///< share of the cells that are judged
    double angle5 = 0.0;  ///< of their smallest corners, in degrees: 5 % are smaller
    double median = 0.0;
    std::size_t components = 0;
    std::size_t specks = 0; ///< components of under 12 quads
    std::size_t loops = 0;
    double longest_edge = 0.0;

    /// Counts loops beyond one a component.
    std::int64_t holes() const {
        return static_cast<std::int64_t>(loops) - static_cast<std::int64_t>(components);
    }
};

/// Measures the cells. @param judged  which cells' angles and slenderness count. Cost: O(cells log cells).
template <class Judged>
MeshShape shape_of(const core::QuadComplex& mesh, const Judged& judged) {
    constexpr std::size_t least_component = 12;
    MeshShape shape{.quads = mesh.cells.size(),
                    .loops = border_loops(mesh),
                    .longest_edge = core::longest_edge(mesh)};
    for (const std::size_t quads : component_sizes(mesh)) {
        ++shape.components;
        shape.specks += quads < least_component;
    }
    std::vector<double> angles;
    std::size_t slivers = 0;
    for (const core::Cell& cell : mesh.cells) {
        if (!judged(cell))
            continue;
        const CellOutline outline(mesh, cell);
        angles.push_back(smallest_corner(outline));
        slivers += slenderness(outline) > most_slender;
    }
    if (angles.empty())
        return shape;
    std::sort(angles.begin(), angles.end());
    shape.slivers = static_cast<double>(slivers) / static_cast<double>(angles.size());
    shape.angle5 = angles[(angles.size() - 1) / 20];
    shape.median = angles[angles.size() / 2];
    return shape;
}

inline MeshShape shape_of(const core::QuadComplex& mesh) {
    return shape_of(mesh, [](const core::Cell&) { return true; });
}

} // namespace wakesurf::tests
