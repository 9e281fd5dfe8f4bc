#include "protocol/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::protocol {

namespace {

/// In [n, n + 1) where node n is the nearest.
double shifted(double coordinate, double origin, double step) {
    return (coordinate - origin) / step + 0.5;
}

} // namespace

Lattice lattice_over(const core::Box& domain, int bits) {
    const core::Vec3 extent = domain.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    const double side = longest > 0.0 ? 1.01 * longest : 1.0;
    Lattice lattice;
    lattice.bits = bits;
    lattice.step = side / lattice.last();
    lattice.origin = 0.5 * (domain.lo + domain.hi) - core::Vec3(0.5 * side);
    return lattice;
}

bool valid(const Lattice& lattice) {
    return core::finite(lattice.origin) && std::isfinite(lattice.step) && lattice.step > 0.0 &&
           lattice.bits >= 1 && lattice.bits <= max_lattice_bits;
}

bool on_lattice(const Lattice& lattice, const core::Vec3& p) {
    const double end = lattice.last() + 1.0;
    const double x = shifted(p.x, lattice.origin.x, lattice.step);
    const double y = shifted(p.y, lattice.origin.y, lattice.step);
    const double z = shifted(p.z, lattice.origin.z, lattice.step);
    return x >= 0.0 && x < end && y >= 0.0 && y < end && z >= 0.0 && z < end;
}

LatticePoint quantise(const Lattice& lattice, const core::Vec3& p) {
    // None is negative, so cutting off is rounding down.
    return {static_cast<std::int32_t>(shifted(p.x, lattice.origin.x, lattice.step)),
            static_cast<std::int32_t>(shifted(p.y, lattice.origin.y, lattice.step)),
            static_cast<std::int32_t>(shifted(p.z, lattice.origin.z, lattice.step))};
}

core::Vec3 dequantise(const Lattice& lattice, const LatticePoint& node) {
    return lattice.origin + lattice.step * core::Vec3(node[0], node[1], node[2]);
}

} // namespace wakesurf::protocol
