// Logins, which browsers get for the token or the key of a share link: a text that only pages of the same
// origin can read, shown with every request. It is signed, so that valid logins need no storage, whatever
// their number: no login can displace another.
#pragma once

#include "server/base/secret.hpp"
#include "server/base/unix_time.hpp"
#include "server/net/login_store.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// The text of a login: its id, its times, its link, and a signature. A server recognizes logins, also those
/// of its earlier runs, without a list of them.
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

struct Login {
    std::string grant; ///< the share link; empty: the server's own token
    std::string id;
};

/// Makes and checks logins. Loop thread only. A login ends with logout, with its token or link, a week after
/// its last renewal, or a month after it was made.
class Logins {
  public:
    struct Services {
        Entropy& entropy;
        UnixTime unix_time;
        /// Returns the secret of the token (empty grant) or of a share link; empty once that has ended.
        std::function<std::optional<SecretDigest>(const std::string& grant)> secret;
        LoginStore& kept;
    };

    explicit Logins(Services services) : services_(std::move(services)) {}

    /// Makes a login. REQUIRES: the link has not ended.
    std::string make(const std::string& grant);

    /// Returns the same login for another week; empty as find().
    std::optional<std::string> renew(std::string_view text);

    /// Returns the login of a text; empty if it is not valid. Takes the same time for every wrong signature.
    std::optional<Login> find(std::string_view text) const;

    /// Ends a login, with all texts of it, and returns it if it was one. `kept` is called once a restarted
    /// server will know it.
    std::optional<Login> end(std::string_view text, LoginStore::Done kept);

    /// Says whether it has not been ended.
    bool lasts(const std::string& grant, const std::string& id) const;

  private:
    std::optional<SignedLogin> sound(std::string_view text) const;
    std::optional<SignedLogin> good(std::string_view text) const;

    Services services_;
};

} // namespace wakesurf::server
