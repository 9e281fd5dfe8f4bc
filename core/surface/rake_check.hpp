// Checks what every rake has to be, wherever its surfaces may lie: the one check of rakes that are asked for,
// kept or read from a file.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"

namespace wakesurf::core {

/// Error: InvalidArgument (too few or coinciding points, non-finite coordinates, fewer than 2 seeds).
Result<void> check_rake(const Rake& rake);

} // namespace wakesurf::core
