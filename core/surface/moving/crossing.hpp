// The border of the surface at the fluid's boundary: on an edge from a living to a dead vertex, the particle
// that meets the boundary of the domain, or a body, at the mesh's time. It is searched among the particles of
// the edge when both its ends were alive, at the beginning of the step.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/refinement_context.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

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

} // namespace wakesurf::core
