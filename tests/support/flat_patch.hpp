// A flat moving mesh on whole numbers, where every invariant can be checked exactly: a vertex lies at its column and row.
#pragma once

#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/snapshot.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// columns x rows cells of side 1, laid as first_row.cpp lays the patch of a time surface. Closed: the last column is the
/// first, on a round tube of that many columns.
inline core::MovingMesh flat_patch(int columns, int rows, bool closed = false) {
    core::MovingMesh mesh;
    mesh.lattice = {double(columns), closed, double(rows)};
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
            point.place = {double(column), double(row)};
            mesh.vertices.add(point, core::VertexRole::Free, 0.0);
        }
    const auto at = [&](int row, int column) {
        return static_cast<core::VertexId>(row * across + column % across);
    };
    std::vector<core::Cell> cells;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            core::Cell cell;
            cell.corner = {at(row, column), at(row, column + 1), at(row + 1, column + 1),
                           at(row + 1, column)};
            cells.push_back(cell);
        }
    mesh.quads.append(cells, {});
    return mesh;
}

/// For LocalOperations: the middle of an edge as a free vertex.
inline core::VertexId insert_middle(core::MovingMesh& mesh, core::VertexId a, core::VertexId b) {
    return mesh.vertices.add(core::midpoint(mesh, a, b, core::InsertionPolicy::Line).point,
                             core::VertexRole::Free, mesh.time);
}

/// An edge that two cells share but do not know each other by, or that two use in one direction; empty if there is none.
inline std::string slit(const core::MovingMesh& mesh) {
    std::map<std::pair<core::VertexId, core::VertexId>, bool> known;
    for (const core::LinkedCell& slot : mesh.quads.slots())
        if (slot.live)
            for (const core::SubEdge& edge : core::outline(slot.cell)) {
                const bool linked = slot.across[edge.side][edge.half] != core::no_cell;
                if (!known.emplace(std::pair(edge.from, edge.to), linked).second)
                    return "a directed edge is used twice";
            }
    for (const auto& [edge, linked] : known)
        if (linked != (known.count({edge.second, edge.first}) != 0))
            return "the edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second) +
                   (linked ? " has a neighbour without the reverse edge" : " is a slit");
    return {};
}

/// Of a cell of a flat patch; negative when it is turned over.
inline double signed_area(const core::MovingMesh& mesh, const core::Cell& cell) {
    double twice = 0.0;
    for (const core::SubEdge& edge : core::outline(cell)) {
        const core::Vec3 a = mesh.vertices.position[edge.from];
        const core::Vec3 b = mesh.vertices.position[edge.to];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * twice;
}

inline double signed_area(const core::MovingMesh& mesh) {
    double sum = 0.0;
    for (const core::LinkedCell& slot : mesh.quads.slots())
        if (slot.live)
            sum += signed_area(mesh, slot.cell);
    return sum;
}

/// Row of the old less the row of the young side, where they are closest: at the columns of the cell's vertices, since all
/// sides are straight between those. Positive in a cell that is not turned over.
inline double least_height(const core::MovingMesh& mesh, const core::Cell& cell) {
    const auto& place = mesh.vertices.place;
    const auto row_at = [&](std::array<core::VertexId, 3> side, double column) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (side[k] == core::no_vertex || side[k + 1] == core::no_vertex)
                continue;
            const double whole =
                mesh.lattice.columns_between(place[side[k]].column, place[side[k + 1]].column);
            const double part = mesh.lattice.columns_between(place[side[k]].column, column);
            if (part >= 0.0 && part <= whole)
                return std::lerp(place[side[k]].row, place[side[k + 1]].row, part / whole);
        }
        return std::nan("");
    };
    const auto side = [&](std::size_t left, std::size_t mid, std::size_t right) {
        std::array<core::VertexId, 3> all{cell.corner[left], cell.mid[mid], cell.corner[right]};
        if (all[1] == core::no_vertex)
            all = {all[0], all[2], core::no_vertex};
        return all;
    };
    const auto young = side(0, 0, 1);
    const auto old = side(3, 2, 2);
    double least = 1e300;
    for (const auto& vertices : {young, old})
        for (const core::VertexId v : vertices)
            if (v != core::no_vertex) {
                const double height = row_at(old, place[v].column) - row_at(young, place[v].column);
                least = height >= least ? least : height;
            }
    return least;
}

} // namespace wakesurf::tests
