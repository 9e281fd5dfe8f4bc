// Which edges of a moving surface are turned and which are cut. The shorter diagonal of two neighbouring
// triangles is the better edge, and shear changes which that is.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

/// True where turning an edge leaves fewer bridging triangles (see is_bridging()), or makes the worse of
/// the two triangles better and no edge that would be cut; and turns nothing over in (s, t).
bool should_flip(const RefinementContext& context, TriangleId t, unsigned k);

/// Turns edges of the triangles in `queue`, and of those that it changes, until none is worth it, or twenty times as many
/// have been turned. The queue is empty then.
void flip_all(const RefinementContext& context, std::vector<TriangleId>& queue);

struct WantedCut {
    /// The squared length; in a list its rounded_length(), and edges of one length are in order of ids.
    double length;
    VertexId a, b;
    std::uint32_t id_a, id_b; ///< a's is the smaller
    bool must;                ///< else it is only for the shape of what lies beside it
};

/// True where some edge of the triangle, or of what lies beside it, may have to be cut.
bool needs_cut(const RefinementContext& context, TriangleId t);

/// The edges of `candidates`, which are in order, to be cut, the longest first, each once.
/// @param shape  bends, bulges and bridging triangles count; else only what is too long or goes through an
/// obstacle
std::vector<WantedCut>
wanted_cuts(const RefinementContext& context, std::span<const TriangleId> candidates, bool shape);

} // namespace wakesurf::core
