// Checks whether a caller may make a call, by the method's entry in the table. Each call is checked, also
// within a batch.
#pragma once

#include "server/net/methods/method.hpp"

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

} // namespace wakesurf::server
