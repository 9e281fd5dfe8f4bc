// The edges of a moving surface to be cut, and their order.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

struct WantedCut {
    /// The squared length; in a list that of the separation is a million, and edges of one length are taken
    /// in order of ids.
    double length;
    VertexId a, b;
    std::uint32_t id_a, id_b; ///< a's is the smaller
    bool must;                ///< else it is only for the shape of what lies beside it
};

/// True where some edge of the triangle, or of what lies beside it, may have to be cut.
bool needs_cut(const RefinementContext& context, TriangleId t);

/// The edges of `candidates`, which are in order, to be cut, the longest first, each once.
/// @param shape  bends, bulges and webs count; else only what is too long or goes through an obstacle
std::vector<WantedCut>
wanted_cuts(const RefinementContext& context, std::span<const TriangleId> candidates, bool shape);

} // namespace wakesurf::core
