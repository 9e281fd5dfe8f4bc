#include "core/surface/moving/insertion.hpp"

#include "core/surface/moving/line_interpolation.hpp"

namespace wakesurf::core {

namespace {

/// Beyond this the cubic says nothing of the surface; without the limit one run reached edges of 25,000
/// separations (double gyre, streak surface).
constexpr double largest_sagitta = 0.25;

struct ParameterStep {
    double s, t;
};

ParameterStep parameter_step(const MovingMesh& mesh, VertexId a, VertexId b) {
    const MaterialVertices& v = mesh.vertices;
    return {mesh.lattice.s_between(v.s[a], v.s[b]), v.t[b] - v.t[a]};
}

Vec3 tangent(const MovingMesh& mesh, VertexId at, const ParameterStep& step) {
    return mesh.vertices.along_s[at] * step.s + mesh.vertices.along_t[at] * step.t;
}

MaterialPoint average(const MovingMesh& mesh, VertexId a, VertexId b) {
    const MaterialPoint p = mesh.vertices.point(a);
    const MaterialPoint q = mesh.vertices.point(b);
    const RakeLattice& lattice = mesh.lattice;
    MaterialPoint mid;
    mid.carried = 0.5 * (p.carried + q.carried);
    mid.s = lattice.wrapped_s(p.s + 0.5 * lattice.s_between(p.s, q.s));
    mid.t = 0.5 * (p.t + q.t);
    mid.place.column = lattice.wrapped_column(
        p.place.column + 0.5 * lattice.columns_between(p.place.column, q.place.column));
    mid.place.row = 0.5 * (p.place.row + q.place.row);
    mid.birth_area = 0.5f * (p.birth_area + q.birth_area);
    mid.approximated = true;
    mid.error = VertexError::between(p.error, q.error);
    return mid;
}

/// Change of the tangents along a column edge, over its extent in t.
struct ColumnChange {
    Vec3 along_s, along_t;
};

ColumnChange column_change(const MovingMesh& mesh, VertexId from, VertexId to) {
    const MaterialVertices& v = mesh.vertices;
    const double t = v.t[to] - v.t[from];
    return {(v.along_s[to] - v.along_s[from]) / t, (v.along_t[to] - v.along_t[from]) / t};
}

/// Takes a correction that is small beside what it corrects; a large one says that the cell is too coarse for it.
void correct(Vec3& tangent, const Vec3& by) {
    if (glm::dot(by, by) <= 0.0625 * glm::dot(tangent, tangent))
        tangent += by;
}

/// Middle of a cross side, cubic in the tangent along t: its derivative along the side follows from how both tangents change
/// along the columns at either end.
void refine_cross(const MovingMesh& mesh,
                  Carried& mid,
                  VertexId a,
                  VertexId b,
                  VertexId beyond_a,
                  VertexId beyond_b,
                  const Vec3& slope) {
    const ParameterStep step = parameter_step(mesh, a, b);
    const ColumnChange at_a = column_change(mesh, a, beyond_a);
    const ColumnChange at_b = column_change(mesh, b, beyond_b);
    mid.along_t = 0.5 * (mesh.vertices.along_t[a] + mesh.vertices.along_t[b]);
    correct(mid.along_t, 0.125 * (step.s * (at_a.along_s - at_b.along_s) +
                                  step.t * (at_a.along_t - at_b.along_t)));
    mid.along_s = (slope - step.t * mid.along_t) / step.s;
}

/// Middle of a column side: the mixed derivative at its ends follows from how the tangent along t changes across.
void refine_column(const MovingMesh& mesh,
                   Carried& mid,
                   VertexId a,
                   VertexId b,
                   VertexId beyond_a,
                   VertexId beyond_b,
                   const Vec3& slope) {
    const MaterialVertices& v = mesh.vertices;
    const double t = v.t[b] - v.t[a];
    const Vec3 second = column_change(mesh, a, b).along_t;
    const auto mixed = [&](VertexId here, VertexId beyond) {
        const ParameterStep across = parameter_step(mesh, here, beyond);
        return (v.along_t[beyond] - v.along_t[here] - second * across.t) / across.s;
    };
    mid.along_s = 0.5 * (v.along_s[a] + v.along_s[b]);
    correct(mid.along_s, 0.125 * t * (mixed(a, beyond_a) - mixed(b, beyond_b)));
    mid.along_t = slope / t;
}

} // namespace

Vec3 edge_turn(const MovingMesh& mesh, VertexId a, VertexId b) {
    const ParameterStep step = parameter_step(mesh, a, b);
    return tangent(mesh, a, step) - tangent(mesh, b, step);
}

double relative_sagitta(const MovingMesh& mesh, VertexId a, VertexId b) {
    const double bulge = glm::length(edge_turn(mesh, a, b)) / 8.0;
    const double chord = mesh.edge_length(a, b);
    return bulge > 0.0 ? bulge / chord : 0.0;
}

Midpoint midpoint(const MovingMesh& mesh, VertexId a, VertexId b, InsertionPolicy policy) {
    MaterialPoint mid = average(mesh, a, b);
    if (policy == InsertionPolicy::Line)
        return {mid, 0.0};
    const ParameterStep step = parameter_step(mesh, a, b);
    const Vec3 chord = mesh.vertices.position[b] - mesh.vertices.position[a];
    const Vec3 at_a = tangent(mesh, a, step);
    const Vec3 at_b = tangent(mesh, b, step);
    const Vec3 bulge = (at_a - at_b) / 8.0;
    const double sagitta = glm::length(bulge) / glm::length(chord);
    if (!(sagitta <= largest_sagitta))
        return {mid, std::isfinite(sagitta) ? sagitta : 1.0};
    mid.carried.position += bulge;
    // The averaged tangents, corrected so that along the edge they give the cubic's slope; the larger takes more.
    const Vec3 slope = 1.5 * chord - 0.25 * (at_a + at_b);
    const Vec3 missing = slope - (mid.carried.along_s * step.s + mid.carried.along_t * step.t);
    const double s2 = step.s * step.s * glm::dot(mid.carried.along_s, mid.carried.along_s);
    const double t2 = step.t * step.t * glm::dot(mid.carried.along_t, mid.carried.along_t);
    if (s2 + t2 > 0.0) {
        if (step.s != 0.0)
            mid.carried.along_s += missing * (s2 / (s2 + t2) / step.s);
        if (step.t != 0.0)
            mid.carried.along_t += missing * (t2 / (s2 + t2) / step.t);
    }
    return {mid, sagitta};
}

Midpoint
middle_of_side(const MovingMesh& mesh, CellIndex index, std::size_t side, InsertionPolicy policy) {
    const Cell& cell = mesh.quads[index].cell;
    const VertexId a = cell.corner[side];
    const VertexId b = cell.corner[(side + 1) % 4];
    Midpoint mid = midpoint(mesh, a, b, policy);
    if (policy == InsertionPolicy::Line) {
        const LineBulge line = bulge_of_line(mesh, index, side);
        mid.point.carried.position += line.offset;
        mid.bulge = line.share;
        return mid;
    }
    if (mid.bulge > largest_sagitta)
        return mid;
    const VertexId beyond_a = cell.corner[(side + 3) % 4];
    const VertexId beyond_b = cell.corner[(side + 2) % 4];
    const Vec3 chord = mesh.vertices.position[b] - mesh.vertices.position[a];
    const ParameterStep step = parameter_step(mesh, a, b);
    const Vec3 slope = 1.5 * chord - 0.25 * (tangent(mesh, a, step) + tangent(mesh, b, step));
    if (side % 2 == 0)
        refine_cross(mesh, mid.point.carried, a, b, beyond_a, beyond_b, slope);
    else
        refine_column(mesh, mid.point.carried, a, b, beyond_a, beyond_b, slope);
    return mid;
}

} // namespace wakesurf::core
