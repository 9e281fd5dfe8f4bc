#include "core/surface/moving/insertion_error.hpp"

#include "core/surface/moving/surface_tangents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wakesurf::core {

namespace {

/// A place on a side's line on the lattice.
struct LinePoint {
    double parameter; ///< s of a cross side, t of a column side
    Vec3 position;
};

/// The place that follows on the line of a side beyond a corner, in the cell across `across`, which has that corner as its own or as a
/// hanging node. Nothing where there is no such cell.
std::optional<LinePoint> beyond(const MovingMesh& mesh,
                                const LinkedCell& here,
                                std::size_t side,
                                std::size_t across,
                                VertexId corner) {
    const std::size_t facing = (across + 2) % 4;
    const std::size_t half = here.cell.mid[across] != no_vertex && across == (side + 3) % 4 ? 1 : 0;
    const CellIndex neighbour = here.across[across][half];
    if (neighbour == no_cell)
        return std::nullopt;
    const Cell& cell = mesh.quads[neighbour].cell;
    const MaterialVertices& v = mesh.vertices;
    const auto at = [&](VertexId i) {
        return LinePoint{side % 2 == 0 ? v.s[i] : v.t[i], v.position[i]};
    };
    const VertexId near[2] = {cell.corner[facing], cell.corner[(facing + 1) % 4]};
    const VertexId far[2] = {cell.corner[(facing + 3) % 4], cell.corner[(facing + 2) % 4]};
    for (std::size_t k = 0; k < 2; ++k)
        if (near[k] == corner) {
            const std::size_t along = (facing + (k == 0 ? 3 : 1)) % 4;
            return at(cell.mid[along] != no_vertex ? cell.mid[along] : far[k]);
        }
    if (cell.mid[facing] != corner)
        return std::nullopt;
    if (cell.mid[across] != no_vertex)
        return at(cell.mid[across]);
    const LinePoint p = at(far[0]);
    const LinePoint q = at(far[1]);
    const double step = side % 2 == 0 ? mesh.lattice.s_between(p.parameter, q.parameter)
                                      : q.parameter - p.parameter;
    return LinePoint{p.parameter + 0.5 * step, 0.5 * (p.position + q.position)};
}

/// How far the parabola through the edge from a to b and `other`, beyond a, passes from the chord, half-way.
double
sagitta(const MovingMesh& mesh, const LinePoint& other, VertexId a, VertexId b, std::size_t side) {
    const MaterialVertices& v = mesh.vertices;
    const bool cross = side % 2 == 0;
    const double own = cross ? mesh.lattice.s_between(v.s[a], v.s[b]) : v.t[b] - v.t[a];
    const double others =
        cross ? mesh.lattice.s_between(other.parameter, v.s[a]) : v.t[a] - other.parameter;
    const Vec3 change =
        (v.position[b] - v.position[a]) / own - (v.position[a] - other.position) / others;
    return 0.25 * own * own * glm::length(change / (own + others));
}

double chord_error(const MovingMesh& mesh, CellIndex index, std::size_t side) {
    const LinkedCell& here = mesh.quads[index];
    const VertexId a = here.cell.corner[side];
    const VertexId b = here.cell.corner[(side + 1) % 4];
    double error = 0.0;
    if (const auto before = beyond(mesh, here, side, (side + 3) % 4, a))
        error = std::max(error, sagitta(mesh, *before, a, b, side));
    if (const auto after = beyond(mesh, here, side, (side + 1) % 4, b))
        error = std::max(error, sagitta(mesh, *after, b, a, side));
    const double length = mesh.edge_length(a, b);
    if (mesh.vertices.dead(a) || mesh.vertices.dead(b))
        error = std::max(4.0 * error, 0.05 * length);
    return std::min(error, length);
}

double cubic_error(const MovingMesh& mesh, VertexId a, VertexId b) {
    const MaterialVertices& v = mesh.vertices;
    const double s = mesh.lattice.s_between(v.s[a], v.s[b]);
    const double t = v.t[b] - v.t[a];
    const Vec3 at_a = v.along_s[a] * s + v.along_t[a] * t;
    const Vec3 at_b = v.along_s[b] * s + v.along_t[b] * t;
    const Vec3 chord = v.position[b] - v.position[a];
    const double bulge = glm::length(at_a - at_b) / 8.0;
    const double length = glm::length(chord);
    if (!(bulge <= 0.25 * length))
        return std::min(bulge, length);
    const double doubt = glm::length(at_a + at_b - 2.0 * chord);
    return v.dead(a) || v.dead(b) ? std::max(doubt / 4.0, 0.01 * length) : doubt / 12.0;
}

} // namespace

void add_insertion_error(
    MovingMesh& mesh, VertexId made, CellIndex index, std::size_t side, InsertionPolicy policy) {
    MaterialVertices& v = mesh.vertices;
    const Cell& cell = mesh.quads[index].cell;
    const VertexId a = cell.corner[side];
    const VertexId b = cell.corner[(side + 1) % 4];
    if (policy != InsertionPolicy::Linear) {
        v.error[made].placed.add({v.along_s[made], v.along_t[made]}, cubic_error(mesh, a, b));
        return;
    }
    const SurfaceTangents at_a = tangents_in(mesh, cell, side);
    const SurfaceTangents at_b = tangents_in(mesh, cell, (side + 1) % 4);
    v.error[made].placed.add({0.5 * (at_a.s + at_b.s), 0.5 * (at_a.t + at_b.t)},
                             chord_error(mesh, index, side));
}

} // namespace wakesurf::core
