// Made by protocol/api/generate from surface.schema.json: do not edit.
// Checks what the description of surface.set says about values, for C++ callers, who come past its readers.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/surface_parameters.hpp"

namespace wakesurf::core {

/// Checks what only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.
Result<void> check_kind(const SurfaceParameters& parameters);

/// Checks the kind, ranges of numbers, and times beside each other. Error: that of check_kind.
Result<void> check_values(const SurfaceParameters& parameters);

} // namespace wakesurf::core
