// The caller of a method, and the session that the call is about.
#pragma once

#include "server/net/methods/method.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/records/author.hpp"

#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Returns the session a call is about: the one it names, the one its WebSocket has joined, or the one its
/// share link is for. Empty for none, and for methods that are about none.
std::string session_of(const Method& method, const Call& call);

/// Returns what the caller may do in that session now: the role of the place taken there, else the token's or
/// the link's for newcomers.
Role role_in(const std::string& session, const Call& call);

/// Returns the role for what all sessions share: that in the session joined, or else the link's. In a copy
/// that of the link which its maker came by: to be its editor is no right to more than the copy.
Role role_of(const Call& call);

/// Returns Unauthenticated once the share link has ended; NotPermitted for another session than the link's
/// and for a lesser role than the method's; else nothing. Whether there is such a session is not told.
std::optional<protocol::RpcFault> refused(const Method& method, const Call& call);

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
