#include "server/sessions/records/record_room.hpp"

#include "server/base/limits.hpp"

#include <fmt/format.h>

namespace wakesurf::server {

core::Result<void> room_in_session(std::size_t bytes, RoomOf whose) {
    if (bytes <= limits::session_bytes)
        return {};
    return core::over_limit(
        limits::session_bytes,
        fmt::format("the records of {} may take {} KiB together, but would take {}",
                    whose == RoomOf::Copies ? "all copies by one share link" : "a session",
                    limits::session_bytes / 1024, (bytes + 1023) / 1024),
        "delete some, use fewer points and shorter texts, or use another session");
}

core::Result<void> room_beside_others(const core::MemoryAccount* account,
                                      std::size_t bytes,
                                      std::size_t more,
                                      RoomOf whose) {
    if (account == nullptr || bytes <= limits::session_small_bytes)
        return {};
    const bool copies = whose == RoomOf::Copies;
    const std::size_t most = account->budget() / limits::records_part / (copies ? 2 : 1);
    if (account->used(core::MemoryUse::Records) + taken_by_records(more) <= most)
        return {};
    return core::over_limit(
        most,
        fmt::format("the records of all sessions take all {}: {} of --memory, {} MiB",
                    copies ? "that leaves room for copies" : "they may",
                    copies ? "a sixteenth" : "an eighth", most >> 20),
        "delete sessions that are no longer needed, or start the server with a larger --memory");
}

} // namespace wakesurf::server
