// Where a new vertex goes without transported tangents: on the cubic through the two vertices of an edge and those beyond them on the
// same line of the surface. Refinement without tangents (accuracy fast) inserts with it.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

namespace wakesurf::core {

struct LineBulge {
    Vec3 offset; ///< of the middle of the side from that of its chord
    /// Length of the offset over the chord's. Above 0.25 the offset is zero: a cubic says nothing of such a line.
    double share;
    Vec3 doubt;     ///< by which the middle may be off, either way
    double unknown; ///< length by which it may be off in any direction
};

/// The polynomial goes through what there is, in the side's parameter: a cubic inside the surface, a parabola at its edge and beside a
/// tear. Where nothing beyond can be used, or a corner of the cell is dead, the middle stays on the chord, with a large error. Cost: constant.
LineBulge bulge_of_line(const MovingMesh& mesh, CellIndex cell, std::size_t side);

} // namespace wakesurf::core
