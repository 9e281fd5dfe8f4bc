// Removes what a moving surface loses at its boundary: it is clipped where particles leave the domain or meet
// a body, thin rims of tears go, and so do the specks that are left between tears.
#pragma once

#include "core/surface/moving/crossing.hpp"

#include <functional>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Returns the edges from living to dead vertices of the triangles among `candidates`, in order of ids.
std::vector<EdgeCrossing> edges_to_the_dead(const RefinementContext& context,
                                            std::span<const TriangleId> candidates);

/// Cuts triangles that have a dead vertex where the surface crosses the boundary at which it ended: one
/// vertex an edge, shared, on the boundary itself. A vertex that came to rest has crossed nothing, and its
/// triangles are removed.
/// @param insert  adds the vertex of a crossing to the mesh's vertices
void clip(const RefinementContext& context,
          std::span<const TriangleId> candidates,
          std::span<const EdgeCrossing> crossings,
          const std::function<VertexId(const EdgeCrossing& crossing)>& insert);

/// Takes thin triangles off the boundary among `candidates`, and what they uncover: along a tear those
/// narrower than 0.15 of the separation, along the border of the parameter rectangle filaments narrower than
/// 0.04 of it.
void erode(const RefinementContext& context, std::span<const TriangleId> candidates);

/// Takes out the parts of the surface with fewer than 12 quads, beside much larger ones and off the rake,
/// that the triangles among `candidates` belong to.
void drop_specks(const RefinementContext& context, std::span<const TriangleId> candidates);

} // namespace wakesurf::core
