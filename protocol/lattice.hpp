// The integer lattice of a dataset: every position on the wire is a node of it, so both ends agree to the bit.
// Twin: web-client/src/protocol/lattice.ts.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <cstdint>

namespace wakesurf::protocol {

using LatticePoint = std::array<std::int32_t, 3>;

struct Lattice {
    core::Vec3 origin{0.0};
    double step = 1.0; ///< distance of neighbouring nodes, in the dataset's length unit
    int bits = 16;     ///< nodes are numbered 0 .. 2^bits - 1 along each axis

    std::int32_t last() const { return (std::int32_t{1} << bits) - 1; }

    bool operator==(const Lattice&) const = default;
};

inline constexpr int max_lattice_bits = 20;

/// The cube of 2^bits nodes a side over a domain enlarged by 1 % of its longest side, both centred alike.
/// A domain without extent gets a cube of side 1.
Lattice lattice_over(const core::Box& domain, int bits = 16);

/// Finite, a positive step, 1 to max_lattice_bits bits.
bool valid(const Lattice& lattice);

/// The nearest node is what is below this.
inline core::Vec3 node_above(const Lattice& lattice, const core::Vec3& p) {
    return (p - lattice.origin) / lattice.step + core::Vec3(0.5);
}

/// Whether the node nearest to `p` exists; false for points that are not finite.
inline bool on_lattice(const Lattice& lattice, const core::Vec3& p) {
    const double end = lattice.last() + 1.0;
    const core::Vec3 node = node_above(lattice, p);
    return node.x >= 0.0 && node.x < end && node.y >= 0.0 && node.y < end && node.z >= 0.0 &&
           node.z < end;
}

/// The nearest node, halves rounded up. REQUIRES: on_lattice(lattice, p).
inline LatticePoint quantise(const Lattice& lattice, const core::Vec3& p) {
    const core::Vec3 node = node_above(lattice, p); // nothing is negative: cutting off rounds down
    return {static_cast<std::int32_t>(node.x), static_cast<std::int32_t>(node.y),
            static_cast<std::int32_t>(node.z)};
}

core::Vec3 dequantise(const Lattice& lattice, const LatticePoint& node);

} // namespace wakesurf::protocol
