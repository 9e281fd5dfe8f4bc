// The integer lattice of a dataset: every position on the wire is a node of it, so both ends agree to the
// bit. Twin: web-client/src/protocol/lattice.ts.
#pragma once

#include "core/base/periodic_axes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace wakesurf::protocol {

using LatticePoint = std::array<std::int32_t, 3>;

/// Describes a cube of nodes.
struct Lattice {
    core::Vec3 origin{0.0}; ///< node 0, 0, 0
    double step = 1.0;      ///< distance of neighbouring nodes, in the dataset's length unit
    int bits = 16;          ///< nodes are numbered 0 .. 2^bits - 1 along each axis

    /// Returns the number of the last node along an axis.
    std::int32_t last() const { return (std::int32_t{1} << bits) - 1; }

    bool operator==(const Lattice&) const = default;
};

inline constexpr int max_lattice_bits = 20;

/// Returns the cube of 2^bits nodes a side over a domain enlarged by 1 % of its longest side, with the same
/// centre. A domain without extent gets a cube of side 1.
Lattice lattice_over(const core::Box& domain, int bits = 16);

/// The same over a domain that repeats: over its repetitions then, with more bits, so that the step is no longer.
Lattice lattice_over(const core::Box& domain, const core::PeriodicAxes& periodic);

/// Says whether a lattice is finite, with a positive step and 1 to max_lattice_bits bits.
bool valid(const Lattice& lattice);

/// Rounds many points to the nodes of one lattice.
class LatticeRounding {
  public:
    /// Rounds to the nodes of `lattice`.
    explicit LatticeRounding(const Lattice& lattice)
        : origin_(lattice.origin), per_step_(1.0 / lattice.step), last_(lattice.last()) {}

    /// Says whether the node nearest to `p` exists; false for points that are not finite.
    bool holds(const core::Vec3& p) const {
        const core::Vec3 n = above(p);
        const double end = last_ + 1.0;
        // Computed without branches: every vertex of every update asks this, and the answer is nearly always
        // true.
        return (n.x >= 0.0) & (n.x < end) & (n.y >= 0.0) & (n.y < end) & (n.z >= 0.0) & (n.z < end);
    }

    /// Returns the nearest node, halves rounded up; an arbitrary node if holds() is false.
    LatticePoint nearest(const core::Vec3& p) const {
        const core::Vec3 n = above(p); // nothing is negative: cutting off rounds down
        return {cut(n.x), cut(n.y), cut(n.z)};
    }

  private:
    /// Returns the coordinates whose integer part is the nearest node.
    core::Vec3 above(const core::Vec3& p) const {
        return (p - origin_) * per_step_ + core::Vec3(0.5);
    }

    /// In this order NaN becomes 0.
    std::int32_t cut(double value) const {
        return static_cast<std::int32_t>(std::min(std::max(0.0, value), last_));
    }

    core::Vec3 origin_;
    double per_step_;
    double last_;
};

} // namespace wakesurf::protocol
