// What people are told of records that could not be used when the server started.
#pragma once

#include "server/service/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace wakesurf::server {

/// `keptAside` of session.join and session.state: how many there are, and the newest of them.
nlohmann::json kept_aside_json(const Session& session);

/// The notification server.notice of kind `recordsKeptAside`; nothing where the last start could use all.
std::optional<std::string> kept_aside_notice(const Session& session);

} // namespace wakesurf::server
