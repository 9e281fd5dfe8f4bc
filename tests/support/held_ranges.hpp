// Streams whose attributes have known ranges from their first state on, as if they had shown such values
// before: their first state is a KEY, and values in these ranges need no other.
#pragma once

#include "protocol/wire/mesh_stream.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace wakesurf::tests {

/// Returns a stream of surface 1, epoch 1; its next update has seq 0. It has shown one cell with both ends of
/// `ranges`, of speed, s and t, whose ids no surface gets to.
inline protocol::MeshStream
stream_with_ranges(const protocol::Lattice& lattice,
                   const std::vector<protocol::AttributeRange>& ranges) {
    constexpr auto last = std::numeric_limits<std::uint32_t>::max();
    core::KeyedMesh cell;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const auto end = [&](std::size_t a) { return i < 2 ? ranges[a].lo : ranges[a].hi; };
        cell.mesh.position.push_back(lattice.origin);
        cell.mesh.velocity.push_back({end(0), 0.0f, 0.0f});
        cell.mesh.s.push_back(end(1));
        cell.mesh.t.push_back(end(2));
        cell.vertex_id.push_back(last - 4 + i);
    }
    cell.mesh.cells.push_back({});
    cell.mesh.cells.back().corner = {0, 1, 2, 3};
    cell.cell_id.push_back(last);
    protocol::MeshStream stream(1, 1, lattice, true, last);
    if (const auto shown = stream.next(cell, {}); !shown)
        throw std::logic_error(shown.error().message);
    return stream;
}

} // namespace wakesurf::tests
