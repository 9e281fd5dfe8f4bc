// Who makes a call: the role its token gives, and the session a share link is good for. Decided once, at the gate; asked
// before every method.
#pragma once

#include <cstdint>
#include <string>

namespace wakesurf::server {

/// Each may do what the one before it may.
enum class Role : std::uint8_t { Viewer, Editor, Host };

struct Identity {
    Role role = Role::Host; ///< the server's own token is a host's everywhere
    std::string session;    ///< the only session a share link lets in; empty: every one
    std::string grant;      ///< id of the share link; empty: the server's own token

    bool operator==(const Identity&) const = default;
};

} // namespace wakesurf::server
