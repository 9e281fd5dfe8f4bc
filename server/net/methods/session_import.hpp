// The answer to importing a session, over JSON-RPC and over HTTP.
#pragma once

#include "server/sessions/session_directory.hpp"
#include "server/sessions/session_exchange.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace wakesurf::server {

/// Makes the session: {session, name, remaining, notes}. @param name  empty: the file's. Error: OverLimit.
core::Result<nlohmann::json> import_session(SessionDirectory& sessions,
                                            const Datasets& datasets,
                                            ReadSession read,
                                            std::string name);

} // namespace wakesurf::server
