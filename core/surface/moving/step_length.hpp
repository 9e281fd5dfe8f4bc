// The longest time-step of a moving surface.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

namespace wakesurf::core {

/// Returns the length of the next step towards `to`. A row released at the rake falls no further behind than
/// rows are apart, and no edge grows by more than half, unless nothing is inserted between vertices.
/// @param separation  longest edge allowed
/// @param releasing   the rake's particles, rather than the fastest, say what a row is
double
step_length(const MovingMesh& mesh, double to, double separation, bool releasing, bool refines);

} // namespace wakesurf::core
