#include "server/net/kept_logins.hpp"

#include "server/base/private_file.hpp"
#include "server/limits.hpp"
#include "server/net/token_file.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr const char* key_name = "login-key";
constexpr const char* ended_name = "ended-logins";
const std::string all = "*";   ///< in the place of an id
const std::string token = "-"; ///< in the place of a link

std::int64_t oldest_good(std::int64_t now) {
    return now - limits::login_most.count();
}

} // namespace

core::Result<KeptLogins>
KeptLogins::open(const std::filesystem::path& folder, Entropy& entropy, UnixTime unix_time) {
    auto key = secret_from(folder / key_name, entropy, "the key of logins in the --state folder");
    if (!key)
        return tl::unexpected(key.error());
    KeptLogins kept(folder, std::move(*key), std::move(unix_time));
    kept.read();
    return kept;
}

/// What is damaged is left out: a line each.
void KeptLogins::read() {
    std::ifstream in(folder_ / ended_name);
    std::string line, grant, id;
    std::int64_t made = 0;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (!(words >> grant >> id >> made))
            continue;
        Ended& ended = ended_[grant == token ? std::string() : grant];
        if (id == all)
            ended.before = std::max(ended.before, made);
        else
            ended.made[id] = made;
    }
    forget_expired();
}

bool KeptLogins::ended(const std::string& grant, const std::string& id, std::int64_t made) const {
    const auto found = ended_.find(grant);
    return found != ended_.end() &&
           (made <= found->second.before || found->second.made.contains(id));
}

void KeptLogins::end(const std::string& grant, const std::string& id, std::int64_t made) {
    forget_expired();
    ended_[grant].made[id] = made;
    make_room();
    write();
}

/// They are too old to let anyone in.
void KeptLogins::forget_expired() {
    const std::int64_t oldest = oldest_good(unix_time_());
    for (auto& [grant, ended] : ended_)
        std::erase_if(ended.made, [&](const auto& each) { return each.second < oldest; });
    std::erase_if(ended_, [&](const auto& each) {
        return each.second.made.empty() && each.second.before < oldest;
    });
}

void KeptLogins::make_room() {
    std::size_t count = 0;
    Ended* most = nullptr;
    for (auto& [grant, ended] : ended_) {
        count += ended.made.size();
        if (most == nullptr || ended.made.size() > most->made.size())
            most = &ended;
    }
    if (count <= most_ended)
        return;
    for (const auto& [id, made] : std::exchange(most->made, {}))
        most->before = std::max(most->before, made);
}

void KeptLogins::write() const {
    std::string text;
    for (const auto& [grant, ended] : ended_) {
        const std::string& name = grant.empty() ? token : grant;
        if (ended.before >= 0)
            text += name + " " + all + " " + std::to_string(ended.before) + "\n";
        for (const auto& [id, made] : ended.made)
            text += name + " " + id + " " + std::to_string(made) + "\n";
    }
    if (const auto written = write_private_file(folder_ / ended_name, text); !written)
        spdlog::warn("event=logout_not_kept message=\"a login that ended may be good again after a "
                     "restart\" reason=\"{}\"",
                     written.error().message);
}

} // namespace wakesurf::server
