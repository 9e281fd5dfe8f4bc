#include "server/net/login_cookies.hpp"

#include "server/limits.hpp"

#include <algorithm>
#include <numeric>

namespace wakesurf::server {

namespace {

using Counts = std::map<std::string, std::size_t>;

std::size_t total(const Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                           [](std::size_t sum, const auto& each) { return sum + each.second; });
}

} // namespace

LoginCookies::LoginCookies(Services services)
    : services_(std::move(services)),
      key_(services_.kept != nullptr ? services_.kept->key() : random_hex(services_.entropy, 32)),
      started_(services_.unix_time()) {}

core::Result<std::string> LoginCookies::make(const std::string& grant, const std::string& from) {
    forget_expired();
    const auto secret = services_.secret(grant);
    if (!secret || !make_room(grant, from))
        return core::over_limit(limits::logins_from_one,
                                "this link has reached its limit of logins",
                                "log out where you no longer need it, or try again later");
    const SignedLogin login{random_hex(services_.entropy, 16), services_.unix_time(), grant};
    add(login, from, services_.clock.now());
    return cookie_of(login, key_, *secret);
}

LoginCookies::Entries::iterator
LoginCookies::add(const SignedLogin& login, const std::string& from, Time made) {
    entries_.push_back({login, from, made, services_.clock.now(), false});
    const auto entry = std::prev(entries_.end());
    by_id_[login.id] = entry;
    ++count_[login.grant][from];
    return entry;
}

bool LoginCookies::make_room(const std::string& grant, const std::string& from) {
    Counts& counts = count_[grant];
    const bool token = grant.empty();
    const std::size_t most = token ? limits::logins : limits::logins - limits::logins_of_one;
    if (!token && counts[from] >= limits::logins_from_one)
        return forget_unproven(grant, &from);
    if (total(counts) < limits::logins_of_one && entries_.size() < most)
        return true;
    if (forget_unproven(grant, token ? nullptr : &from))
        return true;
    if (!token)
        return false;
    const auto oldest = std::find_if(entries_.begin(), entries_.end(),
                                     [](const Entry& each) { return each.login.grant.empty(); });
    forget(oldest);
    return true;
}

/// The oldest login that has had its time to come back and has not.
bool LoginCookies::forget_unproven(const std::string& grant, const std::string* from) {
    const auto now = services_.clock.now();
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) {
        return !each.proven && each.login.grant == grant &&
               now - each.made >= limits::login_proof && (from == nullptr || each.from == *from);
    });
    if (found == entries_.end())
        return false;
    forget(found);
    return true;
}

/// Signed by us for a secret that is still good, whether or not it has ended.
std::optional<SignedLogin> LoginCookies::sound(std::string_view cookie) const {
    auto login = read_cookie(cookie);
    if (!login)
        return std::nullopt;
    const auto secret = services_.secret(login->grant);
    if (!secret ||
        !same_digest(secret_digest(cookie_of(*login, key_, *secret)), secret_digest(cookie)))
        return std::nullopt;
    return login;
}

std::optional<Login> LoginCookies::find(std::string_view cookie, const std::string& from) {
    const auto login = sound(cookie);
    if (!login)
        return std::nullopt;
    if (!by_id_.contains(login->id) && !adopt(*login, from))
        return std::nullopt;
    const auto found = by_id_.at(login->id);
    if (over(*found)) {
        forget_expired();
        return std::nullopt;
    }
    found->used = services_.clock.now();
    found->proven = true;
    entries_.splice(entries_.end(), entries_, found);
    return Login{login->grant, login->id};
}

/// One that an earlier life of the server made. Of those that this life made, all that are good are known.
bool LoginCookies::adopt(const SignedLogin& login, const std::string& from) {
    const std::chrono::seconds age{services_.unix_time() - login.made};
    if (services_.kept == nullptr || login.made > started_ || age >= limits::login_most ||
        services_.kept->ended(login.grant, login.id, login.made))
        return false;
    forget_expired();
    if (!make_room(login.grant, from))
        return false;
    add(login, from, services_.clock.now() - std::max(age, std::chrono::seconds{0}));
    return true;
}

std::optional<Login> LoginCookies::end(std::string_view cookie) {
    const auto login = sound(cookie);
    if (!login)
        return std::nullopt;
    const auto found = by_id_.find(login->id);
    const bool was = found != by_id_.end();
    if (was)
        forget(found->second);
    if (services_.kept == nullptr || services_.kept->ended(login->grant, login->id, login->made))
        return was ? std::optional(Login{login->grant, login->id}) : std::nullopt;
    services_.kept->end(login->grant, login->id, login->made);
    return Login{login->grant, login->id};
}

bool LoginCookies::lasts(const std::string& id) const {
    const auto found = by_id_.find(id);
    return found != by_id_.end() && !over(*found->second);
}

bool LoginCookies::over(const Entry& entry) const {
    const auto now = services_.clock.now();
    return now - entry.used >= limits::login_idle || now - entry.made >= limits::login_most;
}

/// For good: one of an earlier life would be adopted again.
void LoginCookies::forget_expired() {
    while (!entries_.empty() && over(entries_.front())) {
        const SignedLogin login = entries_.front().login;
        forget(entries_.begin());
        if (services_.kept != nullptr)
            services_.kept->end(login.grant, login.id, login.made);
    }
}

void LoginCookies::forget(Entries::iterator entry) {
    Counts& counts = count_[entry->login.grant];
    if (--counts[entry->from] == 0)
        counts.erase(entry->from);
    if (counts.empty())
        count_.erase(entry->login.grant);
    by_id_.erase(entry->login.id);
    entries_.erase(entry);
}

} // namespace wakesurf::server
