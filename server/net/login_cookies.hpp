// The cookies browsers got for the token or the key of a share link. Each login has its own, random; kept are digests.
#pragma once

#include "server/session/entropy.hpp"
#include "server/session/secret.hpp"

#include <cstddef>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Loop thread only. Bounded: where there are too many, the oldest of the same grant, or else of all, goes.
class LoginCookies {
  public:
    explicit LoginCookies(Entropy& entropy) : entropy_(entropy) {}

    /// A fresh cookie for `grant`; empty: the server's own token.
    std::string make(const std::string& grant);

    /// The grant a cookie was made for. Digests are looked up, and nobody can aim at a digest: the time tells nothing.
    std::optional<std::string> grant_of(std::string_view cookie) const;

  private:
    struct Login {
        SecretDigest digest;
        std::string grant;
    };

    using Logins = std::list<Login>;

    void forget(Logins::iterator login);

    Entropy& entropy_;
    Logins logins_; ///< oldest first
    std::map<SecretDigest, Logins::iterator> by_digest_;
    std::map<std::string, std::size_t> count_; ///< by grant
};

} // namespace wakesurf::server
