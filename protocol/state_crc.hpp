// The checksum of a whole mesh state, by which a client knows that it shows what the server computed. Independent of
// how the state was cut into frames. Twin: web-client/src/protocol/stateCrc.ts.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/lattice.hpp"

#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Positions and cells may be added in any number of pieces; only their order matters.
class StateCrc {
  public:
    void add(std::span<const LatticePoint> positions);
    void add(std::span<const core::Cell> cells);
    std::uint32_t value() const;

  private:
    std::uint32_t positions_ = 0;
    std::uint32_t cells_ = 0;
    std::uint32_t position_count_ = 0;
    std::uint32_t cell_count_ = 0;
};

} // namespace wakesurf::protocol
