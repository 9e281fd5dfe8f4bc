// The mesh of a moving surface as others see it: without empty slots and unreleased vertices, in order of
// ids.
#pragma once

#include "core/surface/keyed_mesh.hpp"
#include "core/surface/moving/moving_mesh.hpp"

#include <span>
#include <string>

namespace wakesurf::core {

/// @param error  of the vertex slots, or empty: the mesh then has no errors
KeyedMesh snapshot(const MovingMesh& mesh, bool deformation, std::span<const float> error = {});

/// What keeps a moving mesh sound: links that answer each other, no dead vertex, no edge without length,
/// nothing turned over in (s, t), each triangle handed out, and all that QuadComplex::validate demands.
/// Empty, or the first violation. Cost: O(cells log cells).
std::string violation(const MovingMesh& mesh);

} // namespace wakesurf::core
