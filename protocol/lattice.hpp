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

/// Whether the node nearest to `p` exists; false for points that are not finite.
bool on_lattice(const Lattice& lattice, const core::Vec3& p);

/// The nearest node, halves rounded up. REQUIRES: on_lattice(lattice, p).
LatticePoint quantise(const Lattice& lattice, const core::Vec3& p);

core::Vec3 dequantise(const Lattice& lattice, const LatticePoint& node);

} // namespace wakesurf::protocol
