// Which session a call is about.
#pragma once

#include "server/rpc/method.hpp"

#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// The session with the id `named`; without one, the session that the WebSocket has joined, or that the share link is for.
/// It has been seen then: see Attendance. Error: InvalidArgument, NotFound.
core::Result<std::shared_ptr<Session>> choose_session(const Call& call,
                                                      const std::optional<std::string>& named);

} // namespace wakesurf::server
