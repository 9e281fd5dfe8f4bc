// Made by protocol/api/generate from shared.schema.json: do not edit.
// What the parameters of many methods share.
#pragma once

#include <optional>
#include <string>

namespace wakesurf::protocol {

/// The parameter of every method on the records of a session.
struct InSession {
    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const InSession&) const = default;
};

} // namespace wakesurf::protocol
