// The caller of a method, and the session that the call is about.
#pragma once

#include "server/net/methods/method.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/records/author.hpp"

#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Returns the participant, if the caller's WebSocket has joined this session; otherwise everybody with the
/// same token or share link is one author, so that a script over HTTP can undo what it did itself.
Author author_of(const Call& call, Session& session, std::optional<std::string> gesture = {});

/// Returns the caller as a maker of links: the name only where the caller is in this session.
LinkMaker maker_of(const Call& call, Session& session);

/// Says whether the caller may go before other people's leases.
bool is_host(const Call& call, const Session& session);

/// Returns the session with the id `named`; without one, the session that the WebSocket has joined, or that
/// the share link is for. It has been seen then: see Attendance. Error: InvalidArgument, NotFound.
core::Result<std::shared_ptr<Session>> choose_session(const Call& call,
                                                      const std::optional<std::string>& named);

} // namespace wakesurf::server
