// A flat moving mesh on whole numbers, where every invariant can be checked exactly: a vertex lies at its
// column and row.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/refinement.hpp"
#include "core/surface/moving/snapshot.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace wakesurf::tests {

/// Makes columns x rows cells of side 1, like origin.cpp for a time surface. Closed: the last column is
/// the first, on a round tube of that many columns.
inline core::MovingMesh flat_patch(int columns, int rows, bool closed = false) {
    core::MovingMesh mesh;
    mesh.rectangle = {.closed = closed, .patch = true};
    const int across = closed ? columns : columns + 1;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < across; ++column) {
            core::MaterialPoint point;
            const double angle = 2.0 * std::numbers::pi * column / columns;
            point.carried.position = closed ? core::Vec3(std::cos(angle), std::sin(angle), row)
                                            : core::Vec3(column, row, 0.0);
            point.carried.along_s = core::Vec3(columns, 0.0, 0.0);
            point.carried.along_t = core::Vec3(0.0, rows, 0.0);
            point.s = double(column) / columns;
            point.t = double(row) / rows;
            mesh.vertices.add(point, core::VertexRole::Free, 0.0);
        }
    const auto at = [&](int row, int column) {
        return static_cast<core::VertexId>(row * across + column % across);
    };
    std::vector<std::array<core::VertexId, 4>> quads;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            quads.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1),
                             at(row + 1, column)});
    mesh.triangles.append(quads);
    return mesh;
}

/// Inserts the middle of an edge as a free vertex; on a boundary edge beside it, like Refinement.
inline core::VertexId insert_middle(core::MovingMesh& mesh, core::TriangleId t, unsigned k) {
    const double part = mesh.triangles[t].across[k] == core::no_triangle ? 0.49 : 0.5;
    return mesh.vertices.add(core::point_on_edge(mesh, t, k, part), core::VertexRole::Free,
                             mesh.time);
}

/// Pairs the triangles without another half, and frees unused vertices.
inline void pair_and_clean(core::MovingMesh& mesh) {
    core::RefinementRules rules;
    rules.separation = 1e9;
    const auto flow = *core::make_analytic_flow("uniform");
    const std::vector<core::TriangleId> loose = mesh.triangles.loose();
    const core::RefinementContext context{mesh, *flow, rules};
    const std::size_t fresh = mesh.vertices.fresh().size();
    for (const core::TriangleId t : core::pair_all(context, loose)) {
        const unsigned k = core::side_to_halve(context, t);
        mesh.triangles.leave_odd(
            std::array{core::MaterialTriangles::Odd{t, k, insert_middle(mesh, t, k)}});
    }
    mesh.vertices.fresh().resize(fresh); // those in the middle of an edge hang on a triangle each
    mesh.triangles.touched().clear();
    core::remove_unused_vertices(mesh);
}

/// Returns the area of a flat patch.
inline double area(const core::MovingMesh& mesh) {
    double twice = 0.0;
    for (core::TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
        if (mesh.triangles[t].live)
            twice += core::area_vector(mesh, t).z;
    return 0.5 * twice;
}

} // namespace wakesurf::tests
