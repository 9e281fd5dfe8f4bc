// The mesh of a streak or time surface as it moves: material vertices, triangles, and how the parameter
// rectangle they came from is laid out.
#pragma once

#include "core/surface/moving/material_triangles.hpp"
#include "core/surface/moving/material_vertices.hpp"

#include <cmath>

namespace wakesurf::core {

/// Columns 0..columns across the rake; a closed rake's last column is its first.
struct RakeLattice {
    double columns = 1.0;
    bool closed = false;
    double last_row = 0.0; ///< of a patch; rows of a streak surface have no last one
    /// The sign of the area in (s, t) of the triangles in the order of their vertices: 1 or -1.
    double facing = 1.0;

    /// Returns the difference from one seed parameter to another the short way round.
    double s_between(double from, double to) const {
        return closed ? to - from - std::round(to - from) : to - from;
    }

    double columns_between(double from, double to) const {
        return closed ? to - from - columns * std::round((to - from) / columns) : to - from;
    }

    double wrapped_s(double s) const { return closed ? s - std::floor(s) : s; }

    double wrapped_column(double column) const {
        return closed ? column - columns * std::floor(column / columns) : column;
    }
};

/// The difference of two places in the parameter rectangle.
struct ParameterStep {
    double s, t;
};

struct MovingMesh {
    MaterialVertices vertices;
    MaterialTriangles triangles;
    RakeLattice lattice;
    double time = 0.0; ///< simulation time the living vertices hold at

    ParameterStep parameter_step(VertexId a, VertexId b) const {
        return {lattice.s_between(vertices.s[a], vertices.s[b]), vertices.t[b] - vertices.t[a]};
    }

    Vec3 edge(VertexId a, VertexId b) const { return vertices.position[b] - vertices.position[a]; }

    double edge_length(VertexId a, VertexId b) const {
        return glm::length(vertices.position[a] - vertices.position[b]);
    }
};

inline std::size_t memory_of(const MovingMesh& mesh) {
    return mesh.vertices.bytes() + mesh.triangles.bytes();
}

/// A vertex takes so many bytes more while the mesh to show is made.
inline constexpr std::size_t shown_bytes = 250;

/// Returns the memory with that of a step: tests of triangles, samples, an array that grows.
/// @param cuts  as many edges are about to be cut: each becomes two triangles and a vertex more
inline std::size_t memory_while_moving(const MovingMesh& mesh, std::size_t cuts = 0) {
    const std::size_t kept = memory_of(mesh) + cuts * (2 * sizeof(Triangle) + vertex_bytes);
    return kept + 2 * kept / 3;
}

} // namespace wakesurf::core
