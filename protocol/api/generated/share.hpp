// Made by protocol/api/generate from share.schema.json: do not edit.
// Share links: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/base/nullable.hpp"
#include "protocol/api/generated/shared.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Holds the parameters of session.share.
struct SessionShare : InSession {
    static constexpr std::string_view method = "session.share";

    /// viewers look, editors edit, hosts also decide who may be here
    std::string role;
    /// how long the link is valid; if left out, 7 days, or as long as the link you came by; null:
    /// until it is revoked (s)
    Nullable<std::uint64_t> expires_in;
};

/// Holds the parameters of session.shares.
struct SessionShares : InSession {
    static constexpr std::string_view method = "session.shares";
};

/// Holds the parameters of session.unshare.
struct SessionUnshare : InSession {
    static constexpr std::string_view method = "session.unshare";

    /// an id from session.shares
    std::string grant;
    /// true: also revoke the links that were made through it, directly or indirectly
    bool children = false;
};

/// Holds the parameters of session.setRole.
struct SessionSetRole : InSession {
    static constexpr std::string_view method = "session.setRole";

    /// an id from session.state
    std::string participant;
    /// viewers look, editors edit, hosts also decide who may be here
    std::string role;
};

/// Holds the parameters of session.kick.
struct SessionKick : InSession {
    static constexpr std::string_view method = "session.kick";

    /// an id from session.state
    std::string participant;
};

void read(CheckedJson& in, SessionShare& out);
void read(CheckedJson& in, SessionUnshare& out);
void read(CheckedJson& in, SessionSetRole& out);
void read(CheckedJson& in, SessionKick& out);

} // namespace wakesurf::protocol
