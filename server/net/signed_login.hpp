// The text of a login's cookie: which login it is, since when, by which link, and a signature, so that a server that starts again knows
// the logins of its predecessor without a list of them.
#pragma once

#include "server/base/secret.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct SignedLogin {
    std::string id;        ///< 32 hexadecimal digits; no secret without the signature
    std::int64_t made = 0; ///< seconds since 1970
    std::string grant;     ///< the share link; empty: the server's own token
};

/// HMAC-SHA256 with `key` over the login and the secret that it was made for: another token, or a link of the same name, is not what it
/// was made for. Throws std::runtime_error where the system has no HMAC.
std::string cookie_of(const SignedLogin& login, std::string_view key, const SecretDigest& secret);

/// What a cookie says, whoever wrote it; nothing for what is none.
std::optional<SignedLogin> read_cookie(std::string_view cookie);

} // namespace wakesurf::server
