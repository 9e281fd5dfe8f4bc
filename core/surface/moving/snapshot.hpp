// The mesh of a moving surface as others see it: without empty slots and unreleased vertices, in order of
// ids.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"
#include "core/surface/moving/step_errors.hpp"
#include "core/surface/quad_complex.hpp"

#include <string>

namespace wakesurf::core {

/// The optional arrays of the mesh.
struct ShownArrays {
    bool deformation = false;
    bool tangents = false;
};

/// @param errors  of steps, or nothing: the mesh then has no errors
/// @param errors_until  the steps before are in the errors of the vertices
KeyedMesh snapshot(const MovingMesh& mesh,
                   const ShownArrays& arrays,
                   const StepErrors* errors = nullptr,
                   double errors_until = 0.0);

/// Returns the first violation of what keeps a moving mesh sound, or nothing: links that answer each other,
/// no dead vertex, no edge without length, nothing turned over in (s, t), each triangle handed out, and all
/// that QuadComplex::validate demands. Cost: O(cells log cells).
std::string violation(const MovingMesh& mesh);

} // namespace wakesurf::core
