#include "core/surface/moving/insertion_error.hpp"

#include "core/surface/moving/line_interpolation.hpp"
#include "core/surface/moving/surface_tangents.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

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
    if (policy != InsertionPolicy::Line) {
        v.error[made].placed.add({v.along_s[made], v.along_t[made]}, cubic_error(mesh, a, b));
        return;
    }
    const SurfaceTangents at_a = tangents_in(mesh, cell, side);
    const SurfaceTangents at_b = tangents_in(mesh, cell, (side + 1) % 4);
    v.error[made].placed.add({0.5 * (at_a.s + at_b.s), 0.5 * (at_a.t + at_b.t)},
                             bulge_of_line(mesh, index, side).error);
}

} // namespace wakesurf::core
