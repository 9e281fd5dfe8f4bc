// The cookies browsers got for the token or the key of a share link. Each login has its own, random; kept are digests. No one's login
// makes room for somebody else's: who logs in too often is refused.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "server/base/entropy.hpp"
#include "server/base/secret.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct Login {
    std::string grant; ///< the share link; empty: the server's own token
    std::uint64_t number = 0;
};

/// Loop thread only. A login ends with logout, a week after its last use, or a month after it was made.
class LoginCookies {
  public:
    LoginCookies(Entropy& entropy, const core::Clock& clock) : entropy_(entropy), clock_(clock) {}

    /// A fresh cookie. Where there are too many for `grant` from one address, the oldest of those that were never used goes.
    /// Error: OverLimit where there is none. Who has the server's own token always gets one, before others who do.
    core::Result<std::string> make(const std::string& grant, const std::string& from);

    /// Whose a cookie is; that is a use of it. Digests are looked up, and no one can aim at a digest: the time tells nothing.
    std::optional<Login> find(std::string_view cookie);

    /// Ends a login; what it was, if it was one.
    std::optional<Login> end(std::string_view cookie);

    /// Whether it still is one.
    bool lasts(std::uint64_t number) const;

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Entry {
        Login login;
        SecretDigest digest;
        std::string from;
        Time made;
        Time used;
        bool proven = false; ///< has come back
    };

    using Entries = std::list<Entry>; ///< used least recently first

    bool over(const Entry& entry) const;
    bool make_room(const std::string& grant, const std::string& from);
    bool forget_unproven(const std::string& grant, const std::string* from);
    void forget_expired();
    void forget(Entries::iterator entry);

    Entropy& entropy_;
    const core::Clock& clock_;
    Entries entries_;
    std::uint64_t next_ = 1;
    std::map<SecretDigest, Entries::iterator> by_digest_;
    std::map<std::uint64_t, Entries::iterator> by_number_;
    std::map<std::string, std::map<std::string, std::size_t>> count_; ///< by grant, by address
};

} // namespace wakesurf::server
