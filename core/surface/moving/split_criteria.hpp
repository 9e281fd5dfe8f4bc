// The edges of a moving surface that must be cut, and those at which it is torn instead: divergence,
// obstacles, curvature, discontinuity.
// Source: McLoughlin, Laramee, Zhang, SCCG 2010; discontinuity by seed distance: Garth et al. 2008.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

namespace wakesurf::core {

/// The most pressing reason to cut an edge.
enum class Fault : std::uint8_t { None, Long, Wall, Bulge };

Fault fault_of(const RefinementContext& context, VertexId a, VertexId b);

/// Returns the length of edge_bend() beyond which an edge bulges.
double least_bend(const RefinementContext& context);

/// True where the cubic along an edge leaves its chord by more than is drawn straight. @param share  of that
/// which counts
bool bulges(const RefinementContext& context, VertexId a, VertexId b, double share = 1.0);

/// Returns true where the edge from a to b passes through an obstacle: its chord does, deeper than a convex
/// wall makes it dip, and the surface's own middle of the edge is not in the fluid near by.
bool crosses_obstacle(const RefinementContext& context,
                      VertexId a,
                      VertexId b,
                      double squared_length);

/// Returns true where an obstacle is within a quarter of the separation.
bool beside_obstacle(const RefinementContext& context, const Vec3& point);

/// Returns true where a body is in the middle of a triangle, in the same sense.
bool covers_obstacle(const RefinementContext& context, VertexId a, VertexId b, VertexId c);

/// Is true of the inner edge of two triangles that are a good quad without it: it is invisible, so it may be
/// longer than the separation.
/// @param waits  also if a side of that quad is too long itself: sides are cut first, and the edge may be
///               gone then
bool is_diagonal(const RefinementContext& context, TriangleId t, unsigned k, bool waits);

/// True where the surface cannot be followed across an edge that would have to be cut: its ends were released
/// too close to each other, or close and part beside an obstacle, where a tear begins at the boundary of the
/// surface.
bool is_torn(const RefinementContext& context, TriangleId t, unsigned k);

/// True for a triangle with next to no material, a bridging one with little, or one of next to no height:
/// cutting it would have no end.
bool is_crumb(const RefinementContext& context, TriangleId t);

} // namespace wakesurf::core
