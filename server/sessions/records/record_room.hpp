// Bounds the memory of the records of a session, and of all sessions together. Each is small, but one link
// could make many: an edit that makes them more is refused where they would be too much. What is kept
// already is never refused for that.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"

#include <cstddef>

namespace wakesurf::server {

/// Says whether a session is a copy that someone made by a share link. All copies by one link have the room of
/// one session, and leave half of what there is for all to other sessions.
enum class RoomOf { Session, Copies };

/// Error: OverLimit, where a session's records would take `bytes`, or all copies' by one link.
core::Result<void> room_in_session(std::size_t bytes, RoomOf whose = RoomOf::Session);

/// Error: OverLimit, where a session's records would take `bytes`, that is `more` than now, and all
/// sessions' too much of --memory.
/// @param account  may be null: there is room
core::Result<void> room_beside_others(const core::MemoryAccount* account,
                                      std::size_t bytes,
                                      std::size_t more,
                                      RoomOf whose = RoomOf::Session);

/// Returns the bytes that a session with records of so many bytes takes: a participant who comes back is
/// sent what has changed, so they are there twice.
constexpr std::size_t taken_by_records(std::size_t bytes) {
    return 2 * bytes;
}

} // namespace wakesurf::server
