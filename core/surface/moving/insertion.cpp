#include "core/surface/moving/insertion.hpp"

#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Beyond this the cubic says nothing of the surface; without the limit one run reached edges of 25,000
/// separations (double gyre, streak surface).
constexpr double largest_sagitta = 0.25;

/// Takes this part of the doubt, which allows for the worst: it decides whether a vertex is traced again.
constexpr double of_doubt = 0.5;

Vec3 tangent(const MovingMesh& mesh, VertexId at, const ParameterStep& step) {
    return mesh.vertices.along_s[at] * step.s + mesh.vertices.along_t[at] * step.t;
}

bool cubic_holds(const Vec3& turn, const Vec3& chord) {
    return squared(turn) <= 64.0 * largest_sagitta * largest_sagitta * squared(chord);
}

MaterialPoint between(const MovingMesh& mesh, VertexId a, VertexId b, double part) {
    const MaterialPoint p = mesh.vertices.point(a);
    const MaterialPoint q = mesh.vertices.point(b);
    const ParameterRectangle& rectangle = mesh.rectangle;
    MaterialPoint mid;
    mid.carried = (1.0 - part) * p.carried + part * q.carried;
    mid.s = rectangle.wrapped_s(p.s + part * rectangle.s_between(p.s, q.s));
    mid.t = p.t + part * (q.t - p.t);
    mid.birth_area = 0.5f * (p.birth_area + q.birth_area);
    mid.approximated = true;
    mid.error = VertexError::between(p.error, q.error);
    return mid;
}

/// A cubic triangle by its values and tangents at three vertices, as Bezier points. Its inner point is that
/// which a quadratic would have.
class CubicPatch {
  public:
    CubicPatch(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c)
        : ab_(mesh.parameter_step(a, b)), ac_(mesh.parameter_step(a, c)) {
        const auto& x = mesh.vertices.position;
        const ParameterStep bc{ac_.s - ab_.s, ac_.t - ab_.t};
        a_ = {x[a], x[a] + tangent(mesh, a, ab_) / 3.0, x[a] + tangent(mesh, a, ac_) / 3.0};
        b_ = {x[b], x[b] - tangent(mesh, b, ab_) / 3.0, x[b] + tangent(mesh, b, bc) / 3.0};
        c_ = {x[c], x[c] - tangent(mesh, c, ac_) / 3.0, x[c] - tangent(mesh, c, bc) / 3.0};
        const Vec3 sides = (a_[1] + a_[2] + b_[1] + b_[2] + c_[1] + c_[2]) / 6.0;
        inner_ = 1.5 * sides - (a_[0] + b_[0] + c_[0]) / 6.0;
    }

    /// The patch is to come near to the value and the tangents of a vertex beyond one of its edges as well.
    void continue_to(const MovingMesh& mesh, VertexId a, VertexId d) {
        const ParameterStep ad = mesh.parameter_step(a, d);
        const double det = ab_.s * ac_.t - ac_.s * ab_.t;
        const double v = (ad.s * ac_.t - ac_.s * ad.t) / det;
        const double w = (ab_.s * ad.t - ad.s * ab_.t) / det;
        const double u = 1.0 - v - w;
        const Slopes slopes = slopes_at(u, v, w);
        const Vec3 value = (u * slopes.a + v * slopes.b + w * slopes.c) / 3.0;
        const std::array<Vec3, 3> missing{mesh.vertices.position[d] - value,
                                          tangent(mesh, d, ab_) - (slopes.b - slopes.a),
                                          tangent(mesh, d, ac_) - (slopes.c - slopes.a)};
        const std::array<double, 3> share{6.0 * u * v * w, 6.0 * w * (u - v), 6.0 * v * (u - w)};
        for (std::size_t i = 0; i < 3; ++i) {
            wanted_ += share[i] * missing[i];
            weight_ += share[i] * share[i];
        }
    }

    /// Moves the inner point to where it does that best, unless the slope at the edge from a to b would
    /// change by more than a quarter: the triangles are too coarse then.
    void settle() {
        const Vec3 move = wanted_ / weight_;
        if (36.0 * squared(move) <= squared(slope_across(0.5))) // not a number must not pass
            inner_ += move;
    }

    /// Sets the tangents at `part` of the way from a to b.
    void set_tangents(double part, MaterialPoint& point) const {
        const Slopes slopes = slopes_at(1.0 - part, part, 0.0);
        const Vec3 along = slopes.b - slopes.a;
        const Vec3 across = slope_across(part);
        const ParameterStep to_c{ac_.s - part * ab_.s, ac_.t - part * ab_.t};
        const double det = ab_.s * to_c.t - to_c.s * ab_.t;
        point.carried.along_s = (to_c.t * along - ab_.t * across) / det;
        point.carried.along_t = (ab_.s * across - to_c.s * along) / det;
    }

  private:
    /// The derivatives by the three barycentric coordinates.
    struct Slopes {
        Vec3 a, b, c;
    };

    Slopes slopes_at(double u, double v, double w) const {
        const double uu = 3.0 * u * u, vv = 3.0 * v * v, ww = 3.0 * w * w;
        const double uv = 6.0 * u * v, vw = 6.0 * v * w, uw = 6.0 * u * w;
        return {uu * a_[0] + uv * a_[1] + uw * a_[2] + vv * b_[1] + vw * inner_ + ww * c_[1],
                uu * a_[1] + uv * b_[1] + uw * inner_ + vv * b_[0] + vw * b_[2] + ww * c_[2],
                uu * a_[2] + uv * inner_ + uw * c_[1] + vv * b_[2] + vw * c_[2] + ww * c_[0]};
    }

    /// Returns the slope from the point at `part` of the way from a to b towards c.
    Vec3 slope_across(double part) const {
        const Slopes slopes = slopes_at(1.0 - part, part, 0.0);
        return slopes.c - (1.0 - part) * slopes.a - part * slopes.b;
    }

    ParameterStep ab_, ac_;
    std::array<Vec3, 3> a_; ///< at a, towards b, towards c
    std::array<Vec3, 3> b_; ///< at b, towards a, towards c
    std::array<Vec3, 3> c_; ///< at c, towards a, towards b
    Vec3 inner_;
    Vec3 wanted_{0.0};
    double weight_ = 0.0;
};

/// The averaged tangents, corrected so that along the edge they have the cubic's slope; the larger takes
/// more.
void set_slope(Carried& mid, const ParameterStep& step, const Vec3& slope) {
    const Vec3 missing = slope - (mid.along_s * step.s + mid.along_t * step.t);
    const double s2 = step.s * step.s * squared(mid.along_s);
    const double t2 = step.t * step.t * squared(mid.along_t);
    if (!(s2 + t2 > 0.0))
        return;
    if (step.s != 0.0)
        mid.along_s += missing * (s2 / (s2 + t2) / step.s);
    if (step.t != 0.0)
        mid.along_t += missing * (t2 / (s2 + t2) / step.t);
}

/// Far from the mean of those at the ends: the triangles are too coarse to tell.
bool differs(const Vec3& tangent, const Vec3& mean) {
    return !(squared(tangent - mean) <= 0.0625 * squared(mean));
}

/// Returns how far the cubic may be off half-way. Its length is about right, its direction where the surface
/// says it is.
Vec3 doubt_of(const EdgeCubic& edge) {
    const Vec3 at_a = edge.slope(edge.a), at_b = edge.slope(edge.b);
    const Vec3 chord = edge.b.position - edge.a.position;
    return cubic_holds(at_a - at_b, chord) ? (at_a + at_b - 2.0 * chord) / 5.0
                                           : 3.0 / 8.0 * (at_a - at_b);
}

void add_insertion_error(const EdgeCubic& edge, MaterialPoint& made) {
    const SurfaceTangents at = tangents_of(made.carried);
    const double length = glm::length(edge.b.position - edge.a.position);
    const Vec3 doubt = doubt_of(edge);
    made.error.placed.add(at, std::min(at.across(doubt), length));
    made.error.apart.add(at, std::min(of_doubt * glm::length(doubt), length));
}

} // namespace

Vec3 edge_turn(const MovingMesh& mesh, VertexId a, VertexId b) {
    const ParameterStep step = mesh.parameter_step(a, b);
    return tangent(mesh, a, step) - tangent(mesh, b, step);
}

Vec3 edge_bend(const MovingMesh& mesh, VertexId a, VertexId b) {
    const Vec3 turn = edge_turn(mesh, a, b);
    const Vec3 chord = mesh.edge(a, b);
    const double l2 = squared(chord);
    return l2 > 0.0 ? turn - chord * (glm::dot(turn, chord) / l2) : turn;
}

EdgeCubic edge_cubic(const MovingMesh& mesh, VertexId a, VertexId b) {
    return {mesh.vertices.point(a).carried, mesh.vertices.point(b).carried,
            mesh.parameter_step(a, b)};
}

Carried EdgeCubic::at(double part) const {
    const double rest = 1.0 - part;
    const Vec3 chord = b.position - a.position;
    const Vec3 at_a = slope(a), at_b = slope(b);
    Carried mid = rest * a + part * b;
    if (!cubic_holds(at_a - at_b, chord))
        return mid;
    mid.position += part * rest * (rest * (at_a - chord) - part * (at_b - chord));
    set_slope(mid, step,
              6.0 * part * rest * chord + rest * (1.0 - 3.0 * part) * at_a +
                  part * (3.0 * part - 2.0) * at_b);
    return mid;
}

MaterialPoint point_between(const MovingMesh& mesh,
                            VertexId a,
                            VertexId b,
                            double part,
                            const Carried& carried,
                            const EdgeCubic& edge) {
    MaterialPoint made = between(mesh, a, b, part);
    made.carried = carried;
    add_insertion_error(edge, made);
    return made;
}

MaterialPoint point_on_edge(const MovingMesh& mesh, TriangleId t, unsigned k, double part) {
    const Triangle& here = mesh.triangles[t];
    const VertexId a = here.begin(k);
    const VertexId b = here.end(k);
    MaterialPoint mid = between(mesh, a, b, part);
    const EdgeCubic edge = edge_cubic(mesh, a, b);
    const SurfaceTangents mean = tangents_of(mid.carried);
    mid.carried = edge.at(part);
    if (cubic_holds(edge_turn(mesh, a, b), mesh.edge(a, b))) {
        const Carried along = mid.carried;
        CubicPatch patch(mesh, a, b, here.opposite(k));
        for (unsigned side = 0; side < 3; ++side)
            if (here.across[side] != no_triangle)
                patch.continue_to(mesh, a, mesh.triangles.opposite_beyond(t, side));
        patch.settle();
        patch.set_tangents(part, mid);
        if (differs(mid.carried.along_s, mean.s) || differs(mid.carried.along_t, mean.t))
            mid.carried = along;
    }
    add_insertion_error(edge, mid);
    return mid;
}

} // namespace wakesurf::core
