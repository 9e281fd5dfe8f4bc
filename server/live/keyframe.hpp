// Encodes the state of a surface as one keyframe, on a compute thread, for clients that have none of it.
#pragma once

#include "server/live/update_ring.hpp"

#include <cstdint>
#include <memory>

namespace wakesurf::server {

/// Returns the update as a key; null where there is no memory for it within 100 ms, and it has to be asked
/// for again. Thread-safe. Cost: of encoding all vertices.
/// @param state  the state that the update leads to
/// @param number  the surface's on the wire
/// @param account  null: memory is not counted
SharedUpdate keyframe_of(const Update& update,
                         std::shared_ptr<const protocol::WireMesh> state,
                         std::uint32_t number,
                         const core::MemoryAccount* account);

} // namespace wakesurf::server
