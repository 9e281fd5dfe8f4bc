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

core::Result<std::string> LoginCookies::make(const std::string& grant, const std::string& from) {
    forget_expired();
    if (!make_room(grant, from))
        return core::over_limit(limits::logins_from_one,
                                "this link has reached its limit of logins",
                                "log out where you no longer need it, or try again later");
    const auto now = clock_.now();
    std::string cookie = random_hex(entropy_, 32);
    entries_.push_back({{grant, next_++}, secret_digest(cookie), from, now, now, false});
    const auto entry = std::prev(entries_.end());
    by_digest_[entry->digest] = entry;
    by_number_[entry->login.number] = entry;
    ++count_[grant][from];
    return cookie;
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
    const auto now = clock_.now();
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) {
        return !each.proven && each.login.grant == grant &&
               now - each.made >= limits::login_proof && (from == nullptr || each.from == *from);
    });
    if (found == entries_.end())
        return false;
    forget(found);
    return true;
}

std::optional<Login> LoginCookies::find(std::string_view cookie) {
    const auto found = by_digest_.find(secret_digest(cookie));
    if (found == by_digest_.end() || over(*found->second))
        return std::nullopt;
    Entry& entry = *found->second;
    entry.used = clock_.now();
    entry.proven = true;
    entries_.splice(entries_.end(), entries_, found->second);
    return entry.login;
}

std::optional<Login> LoginCookies::end(std::string_view cookie) {
    const auto found = by_digest_.find(secret_digest(cookie));
    if (found == by_digest_.end())
        return std::nullopt;
    Login login = found->second->login;
    forget(found->second);
    return login;
}

bool LoginCookies::lasts(std::uint64_t number) const {
    const auto found = by_number_.find(number);
    return found != by_number_.end() && !over(*found->second);
}

bool LoginCookies::over(const Entry& entry) const {
    const auto now = clock_.now();
    return now - entry.used >= limits::login_idle || now - entry.made >= limits::login_most;
}

void LoginCookies::forget_expired() {
    while (!entries_.empty() && over(entries_.front()))
        forget(entries_.begin());
}

void LoginCookies::forget(Entries::iterator entry) {
    Counts& counts = count_[entry->login.grant];
    if (--counts[entry->from] == 0)
        counts.erase(entry->from);
    if (counts.empty())
        count_.erase(entry->login.grant);
    by_digest_.erase(entry->digest);
    by_number_.erase(entry->login.number);
    entries_.erase(entry);
}

} // namespace wakesurf::server
