#include "server/net/login_cookies.hpp"

#include "server/limits.hpp"

#include <algorithm>

namespace wakesurf::server {

std::string LoginCookies::make(const std::string& grant) {
    if (count_[grant] >= limits::cookies_of_one)
        forget(std::find_if(logins_.begin(), logins_.end(),
                            [&](const Login& each) { return each.grant == grant; }));
    else if (logins_.size() >= limits::cookies)
        forget(logins_.begin());
    std::string cookie = random_hex(entropy_, 32);
    logins_.push_back({secret_digest(cookie), grant});
    by_digest_[logins_.back().digest] = std::prev(logins_.end());
    ++count_[grant];
    return cookie;
}

std::optional<std::string> LoginCookies::grant_of(std::string_view cookie) const {
    const auto found = by_digest_.find(secret_digest(cookie));
    if (found == by_digest_.end())
        return std::nullopt;
    return found->second->grant;
}

void LoginCookies::forget(Logins::iterator login) {
    if (--count_[login->grant] == 0)
        count_.erase(login->grant);
    by_digest_.erase(login->digest);
    logins_.erase(login);
}

} // namespace wakesurf::server
