// Lengths, areas and angles of a moving surface's triangles, in space and in the parameter rectangle: the
// input of the refinement criteria.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

inline double squared(const Vec3& v) {
    return glm::dot(v, v);
}

inline double squared_length(const MovingMesh& mesh, VertexId a, VertexId b) {
    return squared(mesh.edge(a, b));
}

/// Returns a vector along the normal, of twice the area.
inline Vec3 area_vector(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c) {
    return glm::cross(mesh.edge(a, b), mesh.edge(a, c));
}

inline Vec3 area_vector(const MovingMesh& mesh, TriangleId t) {
    const auto& v = mesh.triangles[t].vertex;
    return area_vector(mesh, v[0], v[1], v[2]);
}

/// Returns 1 for an equilateral triangle, 0 for one without area.
inline double quality_of(double area_squared, double edges) {
    return edges > 0.0 ? 2.0 * std::sqrt(3.0 * area_squared) / edges : 0.0;
}

inline double quality(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c) {
    return quality_of(squared(area_vector(mesh, a, b, c)), squared_length(mesh, a, b) +
                                                               squared_length(mesh, b, c) +
                                                               squared_length(mesh, c, a));
}

inline double quality(const MovingMesh& mesh, TriangleId t) {
    const auto& v = mesh.triangles[t].vertex;
    return quality(mesh, v[0], v[1], v[2]);
}

inline unsigned longest_edge_of(const MovingMesh& mesh, TriangleId t) {
    const auto& v = mesh.triangles[t].vertex;
    unsigned longest = 0;
    double length = -1.0;
    for (unsigned k = 0; k < 3; ++k)
        if (const double here = squared_length(mesh, v[k], v[(k + 1) % 3]); here > length) {
            length = here;
            longest = k;
        }
    return longest;
}

/// Returns the area in the parameter rectangle over the most that the same steps could have: 1 if they are at
/// right angles there, negative if the triangle is turned over. It alone shows whether something is turned
/// over, however the flow has folded the surface.
inline double material_area(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c) {
    const ParameterStep p = mesh.parameter_step(a, b);
    const ParameterStep q = mesh.parameter_step(a, c);
    const double size = std::abs(p.s * q.t) + std::abs(q.s * p.t);
    const double area = p.s * q.t - q.s * p.t;
    // Rounding of the parameters may have made this of three places on one line.
    const double noise = 2e-15 * (std::abs(p.t) + std::abs(q.t) +
                                  std::abs(mesh.vertices.t[a]) * (std::abs(p.s) + std::abs(q.s)));
    return std::abs(area) > noise ? mesh.rectangle.facing * area / size : 0.0;
}

/// Below it a triangle has next to no material.
constexpr double least_material = 1e-9;

/// A triangle may cover so many times the area that its material has by the tangents.
constexpr double bridging_density = 4.0;

/// True for a triangle that covers much more area than its material has, by the tangents at its vertices: it
/// bridges a fold, between layers of the surface that are close in space and far from each other on it.
/// What is interpolated does not tell.
inline bool is_bridging(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c) {
    const MaterialVertices& v = mesh.vertices;
    double density = 0.0;
    for (const VertexId x : {a, b, c})
        if (v.approximated[x] == 0)
            density = std::max(density, squared(glm::cross(v.along_s[x], v.along_t[x])));
    const ParameterStep p = mesh.parameter_step(a, b);
    const ParameterStep q = mesh.parameter_step(a, c);
    const double material = p.s * q.t - q.s * p.t;
    return density > 0.0 && squared(area_vector(mesh, a, b, c)) >
                                bridging_density * bridging_density * density * material * material;
}

/// Cosine between two vectors that need not have a length; `without` where one has none.
inline double cosine_between(const Vec3& p, const Vec3& q, double without) {
    const double lengths = std::sqrt(squared(p) * squared(q));
    return lengths > 0.0 ? glm::dot(p, q) / lengths : without;
}

inline bool has_dead_vertex(const MovingMesh& mesh, TriangleId t) {
    const auto& v = mesh.triangles[t].vertex;
    return std::any_of(v.begin(), v.end(), [&](VertexId x) { return mesh.vertices.dead(x); });
}

inline bool has_attached_vertex(const MovingMesh& mesh, TriangleId t) {
    const auto& v = mesh.triangles[t].vertex;
    return std::any_of(v.begin(), v.end(),
                       [&](VertexId x) { return mesh.vertices.role[x] == VertexRole::Attached; });
}

/// Says whether an edge is on the border of the parameter rectangle, not at a tear or where particles ended.
inline bool on_rectangle_border(const MovingMesh& mesh, VertexId a, VertexId b) {
    const MaterialVertices& v = mesh.vertices;
    if (v.role[a] == VertexRole::Attached || v.role[b] == VertexRole::Attached)
        return true;
    if (!mesh.rectangle.closed && v.s[a] == v.s[b] && (v.s[a] == 0.0 || v.s[a] == 1.0))
        return true;
    return v.t[a] == v.t[b] && mesh.rectangle.on_end(v.t[a]);
}

} // namespace wakesurf::core
