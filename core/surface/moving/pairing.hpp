// The pairs of triangles of a moving surface that are handed out as quads: pairs stay, and only triangles
// that have lost their other half get a new one. Source: Remacle et al., Blossom-Quad, 2012, whose matching
// is made good locally here.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

/// Says whether a triangle should get another half: its quad's corners are far from right angles, an edge
/// that must not be visible is a side of it, or the vertex that an odd one is handed out with is dead or has
/// come too far.
bool is_poor_pair(const RefinementContext& context, TriangleId t);

/// Gives each of `loose`, the triangles without another half, one: across its edge that is too long to be
/// visible, if it has one; else so that corners are near right angles, along alternating paths if none is
/// left beside it. Returns those that remain without. Cost: O(loose), a few hundred triangles visited for each of
/// these, in parallel; the same result for any number of threads.
std::vector<TriangleId> pair_all(const RefinementContext& context,
                                 std::span<const TriangleId> loose);

/// Returns the edge in whose middle a triangle without another half gets a fourth corner: its longest that is not the
/// rake's, of those whose middle is in the fluid if there is one. A middle that is only drawn must not be in a body that
/// the edge goes along.
unsigned side_to_halve(const RefinementContext& context, TriangleId t);

} // namespace wakesurf::core
