// Where a new vertex goes: on an edge, by cubic interpolation of places and transported tangents (source:
// Schneider, Wiebel, Scheuermann, EuroVis 2009; across the edge by the cubic over the triangles round it).
// Tracing it again from the rake is retrace() in origin.hpp.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

namespace wakesurf::core {

/// Returns by how much the tangent dx/ds ds + dx/dt dt of the edge from a to b changes along it: that at a
/// less that at b.
Vec3 edge_turn(const MovingMesh& mesh, VertexId a, VertexId b);

/// Returns what of the turn points across the chord: what it changes along the chord is no shape.
Vec3 edge_bend(const MovingMesh& mesh, VertexId a, VertexId b);

/// The cubic along an edge.
struct EdgeCubic {
    Carried a, b; ///< at its ends
    ParameterStep step;

    /// Returns the point at `part` of the way; on the chord if the cubic would bulge by more than a quarter
    /// of it. Of the tangents only the slope along the edge is of the cubic's order.
    Carried at(double part) const;

    /// Derivative along the edge, by the part of the way, where the tangents are these.
    Vec3 slope(const Carried& end) const { return end.along_s * step.s + end.along_t * step.t; }
};

EdgeCubic edge_cubic(const MovingMesh& mesh, VertexId a, VertexId b);

/// Returns the point at `part` of the way along edge k of a triangle, flagged approximated. Its tangents are
/// those of the cubic patch over that triangle and its neighbours, so that what is inserted later is as
/// accurate as what is inserted first. Error of the position and, times the edge, of the tangents: fourth
/// order in the edge. Its error is that of the ends and what interpolation may add.
MaterialPoint point_on_edge(const MovingMesh& mesh, TriangleId t, unsigned k, double part = 0.5);

/// The point at `part` of the way from a to b that is known to be at `carried`, flagged approximated.
/// @param edge  between the two when it was interpolated
MaterialPoint point_between(const MovingMesh& mesh,
                            VertexId a,
                            VertexId b,
                            double part,
                            const Carried& carried,
                            const EdgeCubic& edge);

} // namespace wakesurf::core
