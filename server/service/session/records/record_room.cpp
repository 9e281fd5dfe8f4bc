#include "server/service/session/records/record_room.hpp"

#include "server/service/limits.hpp"

#include <fmt/format.h>

namespace wakesurf::server {

core::Result<void> room_in_session(std::size_t bytes) {
    if (bytes <= limits::session_bytes)
        return {};
    return core::over_limit(
        limits::session_bytes,
        fmt::format("the records of a session may take {} KiB together, but would take {}",
                    limits::session_bytes / 1024, (bytes + 1023) / 1024),
        "delete some, use fewer points and shorter texts, or use another session");
}

core::Result<void>
room_beside_others(const core::MemoryAccount* account, std::size_t bytes, std::size_t more) {
    if (account == nullptr || bytes <= limits::session_small_bytes)
        return {};
    const std::size_t most = account->budget() / limits::records_part;
    if (account->used(core::MemoryUse::Records) + taken_by_records(more) <= most)
        return {};
    return core::over_limit(
        most,
        fmt::format("the records of all sessions take all they may: an eighth of --memory, {} MiB",
                    most >> 20),
        "delete sessions that are no longer needed, or start the server with a larger --memory");
}

} // namespace wakesurf::server
