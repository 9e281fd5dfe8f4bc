// Made by protocol/api/generate from share.schema.json: do not edit.
// Share links: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"
#include "protocol/api/nullable.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of session.share: Makes a link that lets people into this session, in a role, until
/// it expires or is taken back. The key is told this once; it works wherever the token does.
struct SessionShare {
    static constexpr std::string_view method = "session.share";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// viewers look, editors edit, hosts also say who may be here
    std::string role;
    /// from now; left out: 7 days, or as long as the link you came by; null: until it is taken back
    /// (s)
    Nullable<std::uint64_t> expires_in;

    bool operator==(const SessionShare&) const = default;
};

void read(CheckedJson& in, SessionShare& out);

/// Parameters of session.shares: The links into this session that are in force, without their keys.
struct SessionShares {
    static constexpr std::string_view method = "session.shares";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const SessionShares&) const = default;
};

void read(CheckedJson& in, SessionShares& out);

/// Parameters of session.unshare: Takes a link back; all who came by it are disconnected. Links
/// that were made by it stay, unless `children` says otherwise.
struct SessionUnshare {
    static constexpr std::string_view method = "session.unshare";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from session.shares
    std::string grant;
    /// also those made by it, and by those it made
    bool children = false;

    bool operator==(const SessionUnshare&) const = default;
};

void read(CheckedJson& in, SessionUnshare& out);

/// Parameters of session.setRole: Sets what a participant may do here, from its next message on. A
/// lesser role than that of the link they came by also holds for their other places, for calls
/// without a place, and for all others who come by that link from now on.
struct SessionSetRole {
    static constexpr std::string_view method = "session.setRole";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from session.state
    std::string participant;
    /// viewers look, editors edit, hosts also say who may be here
    std::string role;

    bool operator==(const SessionSetRole&) const = default;
};

void read(CheckedJson& in, SessionSetRole& out);

/// Parameters of session.kick: Disconnects a participant, whose place is lost. A link it came by
/// stays good: take that back as well.
struct SessionKick {
    static constexpr std::string_view method = "session.kick";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from session.state
    std::string participant;

    bool operator==(const SessionKick&) const = default;
};

void read(CheckedJson& in, SessionKick& out);

} // namespace wakesurf::protocol
