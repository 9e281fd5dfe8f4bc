// An unfinished state: vertices that stay as they were, room for new ones, and what predictions need of the
// state before. Both ends begin it alike and then fill it in, vertex by vertex.
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

/// Begins a draft. REQUIRES: the edit fits `before`.
/// @param edit      the vertices removed and added; the moved ones do not matter yet
/// @param topology  of the state after the edit
WireDraft begin_draft(const WireMesh& before,
                      const TopologyEdit& edit,
                      std::shared_ptr<const WireTopology> topology);

} // namespace wakesurf::protocol
