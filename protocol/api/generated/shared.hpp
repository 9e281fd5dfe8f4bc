// Made by protocol/api/generate from shared.schema.json: do not edit.
// What the parameters of many methods share.
#pragma once

#include "protocol/api/base/checked_json.hpp"

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

inline void read(CheckedJson& in, InSession& out) {
    out.session = in.text_if("session", 256);
}

/// Stands for the parameters of a method that takes none.
struct NoParameters {};

inline void read(CheckedJson&, NoParameters&) {}

} // namespace wakesurf::protocol
