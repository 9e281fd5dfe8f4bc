// The check before Draco, whose encoder hangs on a NaN, aborts on an infinity and takes gigabytes for an
// outlier.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/lattice.hpp"

namespace wakesurf::protocol {

/// Checks that a mesh may be encoded: every position finite and on the lattice, every cell's vertices
/// present, and with `attributes` a finite speed, s and t for each vertex. Error: InvalidArgument for the
/// lattice, OutOfDomain for positions and Corrupt for the rest, stating the count and the first. Cost:
/// O(vertices + cells).
core::Result<void>
guard_mesh(const core::QuadComplex& mesh, const Lattice& lattice, bool attributes);

} // namespace wakesurf::protocol
