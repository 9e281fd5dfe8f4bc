// The border of a moving surface: it is clipped where particles leave the domain or meet a body, and thin
// rims of tears and the specks between tears are removed.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/refinement_context.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// On an edge from a living to a dead vertex, the particle that meets the boundary of the domain, or a
/// body, at the mesh's time. It is searched among the particles of the edge when both its ends were alive,
/// at the beginning of the step.
struct EdgeCrossing {
    VertexId living, dead;
    bool found = false;
    double part = 0.0; ///< of the way from the living to the dead vertex, to 1e-6
    Carried carried{}; ///< there, at the mesh's time
    EdgeCubic edge{};  ///< from which it was interpolated
};

/// Fills in the crossings. An edge crosses nothing in this step if its dead end came to rest, or ended
/// before. If an end was released in this step the boundary is searched on the edge as it is now.
/// Error: as advancing.
/// @param before   simulation time at which the step began
/// @param options  as the mesh was carried with
Result<void> find_crossings(const RefinementContext& context,
                            std::span<EdgeCrossing> crossings,
                            double before,
                            const AdvanceOptions& options,
                            const std::stop_token& stop);

/// Returns the edges from living to dead vertices of the triangles among `candidates`, in order of ids.
std::vector<EdgeCrossing> edges_to_the_dead(const RefinementContext& context,
                                            std::span<const TriangleId> candidates);

/// Cuts triangles that have a dead vertex where the surface crosses the boundary at which it ended: one
/// vertex an edge, shared, on the boundary itself. A vertex that came to rest has crossed nothing, and its
/// triangles are removed.
/// @param crossings  that have been found
/// @param made       the vertex of each
void clip(const RefinementContext& context,
          std::span<const TriangleId> candidates,
          std::span<const EdgeCrossing> crossings,
          std::span<const VertexId> made);

/// Takes thin triangles off the boundary among `candidates`, and what they uncover: along a tear those
/// narrower than 0.15 of the separation, along the border of the parameter rectangle filaments narrower than
/// 0.04 of it.
void erode(const RefinementContext& context, std::span<const TriangleId> candidates);

/// Takes out the parts of the surface with fewer than 12 quads, beside much larger ones and off the rake,
/// that the triangles among `candidates` belong to.
void drop_specks(const RefinementContext& context, std::span<const TriangleId> candidates);

} // namespace wakesurf::core
