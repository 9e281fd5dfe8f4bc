// The mesh of a streak or time surface as it moves: material vertices, linked quads, and how the parameter rectangle they
// came from is laid out.
#pragma once

#include "core/surface/moving/linked_quads.hpp"
#include "core/surface/moving/material_vertices.hpp"

#include <cmath>

namespace wakesurf::core {

/// Columns 0..columns across the rake; a closed rake's last column is its first.
struct RakeLattice {
    double columns = 1.0;
    bool closed = false;
    double last_row = 0.0; ///< of a patch; rows of a streak surface have no last one

    /// From one seed parameter to another the short way round.
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

struct MovingMesh {
    MaterialVertices vertices;
    LinkedQuads quads;
    RakeLattice lattice;
    double time = 0.0; ///< simulation time the living vertices hold at

    /// Row at which the straight edge from `left` to `right` passes the column of `between`, less the row of `between`: on the
    /// lattice every cell's sides are straight, and whole numbers and halves make this exact.
    double row_beyond(VertexId left, VertexId right, VertexId between) const {
        const auto& place = vertices.place;
        const double whole = lattice.columns_between(place[left].column, place[right].column);
        const double part = lattice.columns_between(place[left].column, place[between].column);
        const double rise = place[right].row - place[left].row;
        return place[left].row - place[between].row + (whole != 0.0 ? rise * (part / whole) : 0.0);
    }

    double edge_length(VertexId a, VertexId b) const {
        return glm::length(vertices.position[a] - vertices.position[b]);
    }
};

inline std::size_t memory_of(const MovingMesh& mesh) {
    return mesh.vertices.bytes() + mesh.quads.bytes();
}

/// With what a step takes besides: normals, decisions, samples, an array that grows.
/// @param cuts  as many cells are about to be cut: each becomes two, and a wave of them shares the vertices between
inline std::size_t memory_while_moving(const MovingMesh& mesh, std::size_t cuts = 0) {
    const std::size_t kept = memory_of(mesh) + cuts * (sizeof(LinkedCell) + vertex_bytes);
    return kept + kept / 2;
}

} // namespace wakesurf::core
