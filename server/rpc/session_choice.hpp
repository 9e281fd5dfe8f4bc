// Which session a call is about.
#pragma once

#include "protocol/api/checked_json.hpp"
#include "server/rpc/method.hpp"

#include <memory>

namespace wakesurf::server {

/// Reads `session`; left out, the one the WebSocket has joined, or the share link is for. Checks at the same time that every parameter read
/// before was well-formed. Error: InvalidArgument, NotFound.
core::Result<std::shared_ptr<Session>> read_session(protocol::CheckedJson& in, const Call& call);

} // namespace wakesurf::server
