// The text of a login: which one it is, since when, by which link, and a signature, so that a server knows logins, also those of its
// earlier lives, without a list of them.
#pragma once

#include "server/service/base/secret.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct SignedLogin {
    std::string id;           ///< 32 hexadecimal digits; no secret without the signature
    std::int64_t made = 0;    ///< seconds since 1970
    std::int64_t renewed = 0; ///< the same; the newest use that is known
    std::string grant;        ///< the share link; empty: the server's own token
};

/// HMAC-SHA256 with `key` over the login and the secret that it was made for: another token, or a link of the same name, is not what it
/// was made for. A subprotocol of a WebSocket can hold it. Throws std::runtime_error where the system has no HMAC.
std::string login_text(const SignedLogin& login, std::string_view key, const SecretDigest& secret);

/// What a text says, whoever wrote it; nothing for what is none.
std::optional<SignedLogin> read_login(std::string_view text);

} // namespace wakesurf::server
