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
/// it expires or is revoked. The key is returned only this once; it works wherever the token does.
struct SessionShare {
    static constexpr std::string_view method = "session.share";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// viewers look, editors edit, hosts also decide who may be here
    std::string role;
    /// how long the link is valid; if left out, 7 days, or as long as the link you came by; null:
    /// until it is revoked (s)
    Nullable<std::uint64_t> expires_in;

    bool operator==(const SessionShare&) const = default;
};

void read(CheckedJson& in, SessionShare& out);

/// Parameters of session.shares: Lists the valid links into this session, without their keys.
struct SessionShares {
    static constexpr std::string_view method = "session.shares";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const SessionShares&) const = default;
};

void read(CheckedJson& in, SessionShares& out);

/// Parameters of session.unshare: Revokes a link. Everyone who came by it is disconnected. Links
/// that were made through it stay valid, unless `children` is true.
struct SessionUnshare {
    static constexpr std::string_view method = "session.unshare";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from session.shares
    std::string grant;
    /// true: also revoke the links that were made through it, directly or indirectly
    bool children = false;

    bool operator==(const SessionUnshare&) const = default;
};

void read(CheckedJson& in, SessionUnshare& out);

/// Parameters of session.setRole: Sets what a participant may do here, from their next message on.
/// A role below that of the link they came by also applies to their other places, to calls without
/// a place, and to everyone else who comes by that link from now on.
struct SessionSetRole {
    static constexpr std::string_view method = "session.setRole";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from session.state
    std::string participant;
    /// viewers look, editors edit, hosts also decide who may be here
    std::string role;

    bool operator==(const SessionSetRole&) const = default;
};

void read(CheckedJson& in, SessionSetRole& out);

/// Parameters of session.kick: Disconnects a participant, who loses their place. The link they came
/// by stays valid; revoke it as well to keep them out.
struct SessionKick {
    static constexpr std::string_view method = "session.kick";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from session.state
    std::string participant;

    bool operator==(const SessionKick&) const = default;
};

void read(CheckedJson& in, SessionKick& out);

} // namespace wakesurf::protocol
