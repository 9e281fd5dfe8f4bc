// A rake somebody else drags just now: edits of it have to wait, a few seconds at most.
#pragma once

#include "protocol/api/json_rpc.hpp"
#include "server/service/session/session.hpp"

#include <optional>
#include <string>

namespace wakesurf::server {

/// A fault that says by whom and until when, or nothing when the author may edit the rake.
std::optional<protocol::RpcFault>
leased(const Session& session, const std::string& rake, const Author& author);

} // namespace wakesurf::server
