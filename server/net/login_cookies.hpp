// The cookies browsers got for the token or the key of a share link. Each login has its own, signed; those of the server's earlier lives
// are known by the signature. No one's login makes room for somebody else's: who logs in too often is refused.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "server/base/entropy.hpp"
#include "server/base/secret.hpp"
#include "server/base/unix_time.hpp"
#include "server/net/kept_logins.hpp"
#include "server/net/signed_login.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct Login {
    std::string grant; ///< the share link; empty: the server's own token
    std::string id;
};

/// Loop thread only. A login ends with logout, with the token or link that it was made for, a week after its last use, or a month after
/// it was made. A restart of the server counts as a use.
class LoginCookies {
  public:
    struct Services {
        Entropy& entropy;
        const core::Clock& clock;
        UnixTime unix_time;
        /// Of the token (empty) or of a share link; nothing once it has ended.
        std::function<std::optional<SecretDigest>(const std::string& grant)> secret;
        KeptLogins* kept = nullptr; ///< nothing: they end with the server
    };

    explicit LoginCookies(Services services);

    /// A fresh cookie. Where there are too many for `grant` from one address, the oldest of those that were never used goes.
    /// Error: OverLimit where there is none. Who has the server's own token always gets one, before others who do.
    core::Result<std::string> make(const std::string& grant, const std::string& from);

    /// Whose a cookie is; that is a use of it. Takes the same time whatever is wrong with a signature.
    /// @param from  address that it comes from, to count one of an earlier life by
    std::optional<Login> find(std::string_view cookie, const std::string& from);

    /// Ends a login; what it was, if it was one.
    std::optional<Login> end(std::string_view cookie);

    /// Whether it still is one.
    bool lasts(const std::string& id) const;

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Entry {
        SignedLogin login;
        std::string from;
        Time made;
        Time used;
        bool proven = false; ///< has come back
    };

    using Entries = std::list<Entry>; ///< used least recently first

    std::optional<SignedLogin> sound(std::string_view cookie) const;
    bool adopt(const SignedLogin& login, const std::string& from);
    Entries::iterator add(const SignedLogin& login, const std::string& from, Time made);
    bool over(const Entry& entry) const;
    bool make_room(const std::string& grant, const std::string& from);
    bool forget_unproven(const std::string& grant, const std::string* from);
    void forget_expired();
    void forget(Entries::iterator entry);

    Services services_;
    std::string key_;
    std::int64_t started_; ///< seconds since 1970
    Entries entries_;
    std::map<std::string, Entries::iterator> by_id_;
    std::map<std::string, std::map<std::string, std::size_t>> count_; ///< by grant, by address
};

} // namespace wakesurf::server
