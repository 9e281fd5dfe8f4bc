// Where a new vertex goes: the middle of an edge, by cubic Hermite interpolation with the transported tangents (source: Schneider, Wiebel,
// Scheuermann, EuroVis 2009), or without them by the cubic through the line's neighbouring vertices (line_interpolation.hpp).
// Tracing it again from the rake is retrace() in origin.hpp.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

namespace wakesurf::core {

enum class InsertionPolicy { Line, Hermite, Exact };

/// By how much the tangent dx/ds ds + dx/dt dt of the edge from a to b changes along it: that at a less that at b.
Vec3 edge_turn(const MovingMesh& mesh, VertexId a, VertexId b);

/// How far the cubic through an edge bulges from its chord, over the chord's length: |T_a - T_b| / 8 |b - a|.
double relative_sagitta(const MovingMesh& mesh, VertexId a, VertexId b);

struct Midpoint {
    MaterialPoint point;
    double bulge; ///< relative sagitta of the edge; above 0.25 the point lies on the chord
};

/// The point in the middle of the parameters of a and b, flagged approximated. Line: on the chord, as the edge alone tells no more.
Midpoint midpoint(const MovingMesh& mesh, VertexId a, VertexId b, InsertionPolicy policy);

/// The same for a whole side of a cell, whose other side tells how the tangents change along this one: with it what is inserted
/// later stays as accurate as what is inserted first (Lamb-Oseen streak at separation 0.05: largest error 7.4e-5 instead of 3.5e-4).
Midpoint
middle_of_side(const MovingMesh& mesh, CellIndex index, std::size_t side, InsertionPolicy policy);

} // namespace wakesurf::core
