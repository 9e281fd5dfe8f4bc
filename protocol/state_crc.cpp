#include "protocol/state_crc.hpp"

#include "core/base/crc32c.hpp"

#include <array>

namespace wakesurf::protocol {

static_assert(sizeof(LatticePoint) == 12 && sizeof(core::Cell) == 32,
              "summed as they lie in memory");

void StateCrc::add(std::span<const LatticePoint> positions) {
    positions_ = core::crc32c(std::as_bytes(positions), positions_);
    position_count_ += static_cast<std::uint32_t>(positions.size());
}

void StateCrc::add(std::span<const core::Cell> cells) {
    cells_ = core::crc32c(std::as_bytes(cells), cells_);
    cell_count_ += static_cast<std::uint32_t>(cells.size());
}

std::uint32_t StateCrc::value() const {
    const std::array<std::uint32_t, 4> parts{position_count_, positions_, cell_count_, cells_};
    return core::crc32c(std::as_bytes(std::span(parts)));
}

} // namespace wakesurf::protocol
