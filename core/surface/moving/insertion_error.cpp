#include "core/surface/moving/insertion_error.hpp"

#include "core/surface/moving/line_interpolation.hpp"
#include "core/surface/moving/surface_tangents.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// How far the middle of the cubic from a to b may be off. Its length is about right, its direction where the surface says it is.
Vec3 doubt_of_cubic(const MovingMesh& mesh, VertexId a, VertexId b) {
    const MaterialVertices& v = mesh.vertices;
    const double s = mesh.lattice.s_between(v.s[a], v.s[b]);
    const double t = v.t[b] - v.t[a];
    const Vec3 at_a = v.along_s[a] * s + v.along_t[a] * t;
    const Vec3 at_b = v.along_s[b] * s + v.along_t[b] * t;
    const Vec3 chord = v.position[b] - v.position[a];
    const Vec3 bulge = (at_a - at_b) / 8.0;
    if (!(glm::length(bulge) <= 0.25 * glm::length(chord)))
        return 3.0 * bulge;
    const Vec3 doubt = at_a + at_b - 2.0 * chord;
    return v.dead(a) || v.dead(b) ? doubt / 2.0 : doubt / 6.0;
}

/// Of the doubt, which allows for the worst: what decides whether a vertex is traced again.
constexpr double of_doubt = 0.5;

bool held(CurveEnd end) {
    return end == CurveEnd::Obstacle || end == CurveEnd::Stagnation;
}

} // namespace

void add_insertion_error(
    MovingMesh& mesh, VertexId made, CellIndex index, std::size_t side, InsertionPolicy policy) {
    MaterialVertices& v = mesh.vertices;
    const Cell& cell = mesh.quads[index].cell;
    const VertexId a = cell.corner[side];
    const VertexId b = cell.corner[(side + 1) % 4];
    const double length = mesh.edge_length(a, b);
    const auto add = [&](const SurfaceTangents& at, const Vec3& doubt, double unknown,
                         double most) {
        v.error[made].placed.add(at, std::min(at.across(doubt) + unknown, most));
        v.error[made].apart.add(at, std::min(of_doubt * glm::length(doubt) + unknown, length));
    };
    if (policy != InsertionPolicy::Line) {
        add({v.along_s[made], v.along_t[made]}, doubt_of_cubic(mesh, a, b), 0.0, length);
        return;
    }
    const SurfaceTangents at_a = tangents_in(mesh, cell, side);
    const SurfaceTangents at_b = tangents_in(mesh, cell, (side + 1) % 4);
    const LineBulge line = bulge_of_line(mesh, index, side);
    // A particle that a body holds says nothing of those that pass.
    const bool known = !held(v.end[a]) && !held(v.end[b]);
    add({0.5 * (at_a.s + at_b.s), 0.5 * (at_a.t + at_b.t)}, line.doubt,
        known ? line.unknown : 0.5 * length, known ? length : 0.5 * length);
}

} // namespace wakesurf::core
