// Shear: cross edges that have become oblique to the columns are moved along them, instead of cells being cut. Plane shear
// and Lamb-Oseen take at most 0.6 of the quads then, with a median smallest angle of at least 55 degrees (tests). Source: McLoughlin,
// Laramee, Zhang, SCCG 2010 (shear resolved by reconnecting a particle to a shifted neighbour).
#pragma once

#include "core/surface/moving/local_operations.hpp"
#include "core/surface/moving/refinement_rules.hpp"

#include <optional>

namespace wakesurf::core {

/// The reconnection at the old side of a cell that straightens its cross edge most, if any is worth it.
std::optional<Reconnection> worthwhile_reconnection(const MovingMesh& mesh,
                                                    const LocalOperations& operations,
                                                    CellIndex cell,
                                                    const RefinementRules& rules);

} // namespace wakesurf::core
