// What browsers got for the token or the key of a share link: a text that the page keeps where only pages of its own origin can read it,
// and shows with every request. It is signed, so that nothing has to be remembered of those that are good, however many there are:
// no one's login can take the place of another's.
#pragma once

#include "server/net/kept_logins.hpp"
#include "server/net/signed_login.hpp"
#include "server/service/base/entropy.hpp"
#include "server/service/base/secret.hpp"
#include "server/service/base/unix_time.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct Login {
    std::string grant; ///< the share link; empty: the server's own token
    std::string id;
};

/// Loop thread only. A login ends with logout, with the token or link that it was made for, a week after it was last renewed, or a month
/// after it was made.
class Logins {
  public:
    struct Services {
        Entropy& entropy;
        UnixTime unix_time;
        /// Of the token (empty) or of a share link; nothing once it has ended.
        std::function<std::optional<SecretDigest>(const std::string& grant)> secret;
        KeptLogins& kept;
    };

    explicit Logins(Services services) : services_(std::move(services)) {}

    /// A fresh one. REQUIRES: the link has not ended.
    std::string make(const std::string& grant);

    /// The same login for another week. Error: nothing, as of find().
    std::optional<std::string> renew(std::string_view text);

    /// Whose a text is; nothing for one that is not good. Takes the same time whatever is wrong with a signature.
    std::optional<Login> find(std::string_view text) const;

    /// Ends a login, with all texts of it; what it was, if it was one. `kept` is called once a restart will know it too.
    std::optional<Login> end(std::string_view text, KeptLogins::Done kept);

    /// Whether it has not been ended.
    bool lasts(const std::string& grant, const std::string& id) const;

  private:
    std::optional<SignedLogin> sound(std::string_view text) const;
    std::optional<SignedLogin> good(std::string_view text) const;

    Services services_;
};

} // namespace wakesurf::server
