// Compares two states of a surface on the wire: every client must have the same after an update.
#pragma once

#include "protocol/wire/wire_mesh.hpp"

namespace wakesurf::tests {

/// Compares bit for bit, cells by value.
inline bool same_state(const protocol::WireMesh& a, const protocol::WireMesh& b) {
    return a.lattice_bits == b.lattice_bits && a.time == b.time && a.ranges == b.ranges &&
           a.position == b.position && a.change == b.change && a.codes == b.codes &&
           a.cells() == b.cells();
}

} // namespace wakesurf::tests
