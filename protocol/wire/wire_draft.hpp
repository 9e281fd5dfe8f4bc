// A state in the making: vertices that stay as they were, room for those that come, and what predictions need of the state
// before. Both ends begin it alike and then fill it in, vertex by vertex.
#pragma once

#include "protocol/wire/wire_edit.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::protocol {

struct WireDraft {
    WireMesh after;         ///< unfinished; `change` of moved vertices follows their positions
    std::uint32_t stay = 0; ///< vertices below are of the state before
    std::vector<LatticePoint> position_before; ///< of those that stay, like all that follow
    std::vector<LatticePoint> change_before;
    std::vector<std::vector<std::uint16_t>> codes_before;

    std::uint32_t vertices() const { return static_cast<std::uint32_t>(after.position.size()); }
};

/// @param edit      which vertices go and come; who moves does not matter yet
/// @param topology  of the state after the edit
/// REQUIRES: the edit fits `before`.
WireDraft begin_draft(const WireMesh& before,
                      const TopologyEdit& edit,
                      std::shared_ptr<const WireTopology> topology);

} // namespace wakesurf::protocol
