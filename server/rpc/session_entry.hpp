// A session as session.list tells of it.
#pragma once

#include "server/service/session/session.hpp"
#include "server/service/session/session_trash.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace wakesurf::server {

/// @param now  seconds since 1970: somebody who is in a session uses it now
nlohmann::json session_entry(const Session& session, std::int64_t now);
nlohmann::json session_entry(const TrashedSession& session);

} // namespace wakesurf::server
