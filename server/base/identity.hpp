// The identity of a caller: the role of its token, and the session of its share link. Decided once, at the
// gate; checked before every method.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace wakesurf::server {

/// Names the roles; each may do what the one before it may.
enum class Role : std::uint8_t { Viewer, Editor, Host };

struct Identity {
    Role role = Role::Host; ///< the server's own token is a host's everywhere
    std::string session;    ///< the only session of a share link; empty: every one
    std::string grant;      ///< id of the share link; empty: the server's own token
    /// The link of the maker of a copy, for a link into it; else empty.
    std::string copier{};

    /// Returns the link whose budgets count this: copies give no client more of the server than its link
    /// does.
    const std::string& account() const { return copier.empty() ? grant : copier; }

    bool operator==(const Identity&) const = default;
};

/// Says whether the identity is the copier's own link into the session, which no other client has.
inline bool is_copier_of(const std::string& session, const Identity& identity) {
    return !identity.copier.empty() && identity.session == session;
}

inline constexpr std::array<std::string_view, 3> role_names{"viewer", "editor", "host"};

constexpr std::string_view name(Role role) {
    return role_names[static_cast<std::size_t>(role)];
}

/// Returns the role of a word; empty if it names none.
constexpr std::optional<Role> role_named(std::string_view word) {
    for (std::size_t i = 0; i < role_names.size(); ++i)
        if (role_names[i] == word)
            return static_cast<Role>(i);
    return std::nullopt;
}

/// A visitor: what the token or link allows, and which of its holders this is.
struct Visitor : Identity {
    Visitor(Identity identity = {}, std::string who = {})
        : Identity(std::move(identity)), person(std::move(who)) {}

    /// The person, as far as known: the login of a browser, else the address. May be empty.
    std::string person;
};

} // namespace wakesurf::server
