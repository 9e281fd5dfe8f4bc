// Who makes a call: the role its token has, and the session a share link is good for. Decided once, at the
// gate; asked before every method.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Each may do what the one before it may.
enum class Role : std::uint8_t { Viewer, Editor, Host };

struct Identity {
    Role role = Role::Host; ///< the server's own token is a host's everywhere
    std::string session;    ///< the only session a share link lets in; empty: every one
    std::string grant;      ///< id of the share link; empty: the server's own token
    std::string copier{};   ///< of a link into a copy: the link whose holder made that; else empty

    /// The link that all this is counted for: copies give nobody more of the server than their link does.
    const std::string& account() const { return copier.empty() ? grant : copier; }

    bool operator==(const Identity&) const = default;
};

/// Returns whether it has come by the link into that session which whoever copied it got: no one else has
/// such a link.
inline bool is_copier_of(const std::string& session, const Identity& identity) {
    return !identity.copier.empty() && identity.session == session;
}

inline constexpr std::array<std::string_view, 3> role_names{"viewer", "editor", "host"};

constexpr std::string_view name(Role role) {
    return role_names[static_cast<std::size_t>(role)];
}

/// Returns nothing for what is no role.
constexpr std::optional<Role> role_named(std::string_view word) {
    for (std::size_t i = 0; i < role_names.size(); ++i)
        if (role_names[i] == word)
            return static_cast<Role>(i);
    return std::nullopt;
}

} // namespace wakesurf::server
