// A moving surface whose grid stays as it was released: nothing is inserted, joined, reconnected or torn.
// Source: von Funck, Weinkauf, Theisel, Seidel, Smoke Surfaces: An Interactive Flow Visualization Technique
// Inspired by Real-World Flow Experiments, 2008.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

namespace wakesurf::core {

/// Removes the cells with a dead vertex, which never comes back, and the vertices that no other cell has.
/// Cost: O(cells + vertices).
void leave_out_dead(MovingMesh& mesh);

} // namespace wakesurf::core
