// How far a vertex that was interpolated may be from the true surface, across it, when it is made.
#pragma once

#include "core/surface/moving/insertion.hpp"

namespace wakesurf::core {

/// Adds to the error of `made`, a vertex in the middle of a whole side of a cell that does not have it yet, what interpolation may have
/// made of it.
void add_insertion_error(
    MovingMesh& mesh, VertexId made, CellIndex cell, std::size_t side, InsertionPolicy policy);

} // namespace wakesurf::core
