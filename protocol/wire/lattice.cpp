#include "protocol/wire/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::protocol {

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

Lattice lattice_over(const core::Box& domain, const core::PeriodicAxes& periodic) {
    return core::any(periodic) ? lattice_over(core::repeated(domain, periodic), max_lattice_bits)
                               : lattice_over(domain);
}

bool valid(const Lattice& lattice) {
    return core::finite(lattice.origin) && std::isfinite(lattice.step) && lattice.step > 0.0 &&
           lattice.bits >= 1 && lattice.bits <= max_lattice_bits;
}

} // namespace wakesurf::protocol
