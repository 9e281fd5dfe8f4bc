// The reference for the wire's bytes: a whole mesh by Draco's own means, Edgebreaker, quads cut into
// triangles, positions in 14 bits, speed in 8.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/lattice.hpp"

#include <cstddef>

namespace wakesurf::bench {

/// Returns the bytes of the encoded mesh. @param speed  Draco's, 0 (small) to 10 (fast)
std::size_t
draco_mesh_bytes(const core::QuadComplex& mesh, const protocol::Lattice& lattice, int speed);

} // namespace wakesurf::bench
