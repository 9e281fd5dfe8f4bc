// The text of a login: its id, its times, its link, and a signature. A server recognizes logins, also those
// of its earlier runs, without a list of them.
#pragma once

#include "server/base/secret.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct SignedLogin {
    std::string id;           ///< 32 hexadecimal digits; no secret without the signature
    std::int64_t made = 0;    ///< seconds since 1970
    std::int64_t renewed = 0; ///< likewise; the newest use that is known
    std::string grant;        ///< the share link; empty: the server's own token
};

/// Returns the text, signed by HMAC-SHA256 with `key` over the login and its secret: it does not fit another
/// token, or another link of the same name. A subprotocol of a WebSocket can hold it. Throws
/// std::runtime_error if the system has no HMAC.
std::string login_text(const SignedLogin& login, std::string_view key, const SecretDigest& secret);

/// Parses a text without checking its signature; empty if it is malformed.
std::optional<SignedLogin> read_login(std::string_view text);

} // namespace wakesurf::server
