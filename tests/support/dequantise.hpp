// The position of a lattice node, which clients compute and the server never does. Twin: dequantise in
// web-client/src/protocol/lattice.ts.
#pragma once

#include "protocol/wire/lattice.hpp"

namespace wakesurf::tests {

inline core::Vec3 dequantise(const protocol::Lattice& lattice, const protocol::LatticePoint& node) {
    return lattice.origin + lattice.step * core::Vec3(node[0], node[1], node[2]);
}

} // namespace wakesurf::tests
