// Who a caller is to a session.
#pragma once

#include "server/rpc/method.hpp"
#include "server/service/session/people/grants.hpp"
#include "server/service/session/records/author.hpp"

#include <optional>
#include <string>

namespace wakesurf::server {

/// The participant, if the caller's WebSocket has joined this session; otherwise everybody with the same token or share
/// link is one author, so that a script over HTTP can undo what it did itself.
Author author_of(const Call& call, Session& session, std::optional<std::string> gesture = {});

/// The caller as one who makes links: the name only where the caller is in this session.
LinkMaker maker_of(const Call& call, Session& session);

/// May go before other people's leases.
bool is_host(const Call& call, const Session& session);

} // namespace wakesurf::server
