#include "server/net/kept_logins.hpp"

#include "server/net/token_file.hpp"
#include "server/service/base/private_file.hpp"
#include "server/service/limits.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr const char* key_name = "login-key";
constexpr std::size_t longest_file = std::size_t{4} << 20;
const std::string token = "-"; ///< stands for a link

} // namespace

KeptLogins::KeptLogins(Entropy& entropy, UnixTime unix_time)
    : KeptLogins(random_hex(entropy, 32), {}, std::move(unix_time)) {}

core::Result<KeptLogins> KeptLogins::open(const std::filesystem::path& folder,
                                          Entropy& entropy,
                                          Write write,
                                          UnixTime unix_time) {
    auto key = own_secret(folder / key_name, entropy, "the key of logins in the --state folder");
    if (!key)
        return tl::unexpected(key.error());
    KeptLogins kept(std::move(*key), std::move(write), std::move(unix_time));
    const auto text = read_private_file(folder / ended_name, longest_file);
    if (!text && text.error().code != core::Error::Code::NotFound)
        return core::fail(text.error().code,
                          "the list of ended logins in the --state folder: " + text.error().message,
                          text.error().hint);
    kept.read(text.value_or(std::string()));
    return kept;
}

/// Damaged entries are left out, with a line in the log each.
void KeptLogins::read(const std::string& text) {
    std::istringstream in(text);
    std::string line, grant, id;
    std::int64_t made = 0;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (words >> grant >> id >> made)
            ended_[grant == token ? std::string() : grant][id] = made;
    }
    forget_expired();
}

bool KeptLogins::ended(const std::string& grant, const std::string& id) const {
    const auto found = ended_.find(grant);
    return found != ended_.end() && found->second.contains(id);
}

void KeptLogins::end(const std::string& grant,
                     const std::string& id,
                     std::int64_t made,
                     Done done) {
    forget_expired();
    ended_[grant][id] = made;
    make_room();
    if (!write_)
        return done({});
    write_(text(), [done = std::move(done)](core::Result<void> written) {
        if (!written)
            spdlog::warn("event=logout_not_kept message=\"a login that ended may be good again "
                         "after a restart\" reason=\"{}\"",
                         written.error().message);
        done(std::move(written));
    });
}

/// Those are too old to be valid.
void KeptLogins::forget_expired() {
    const std::int64_t oldest = unix_time_() - limits::login_most.count();
    for (auto& [grant, ended] : ended_)
        std::erase_if(ended, [&](const auto& each) { return each.second < oldest; });
    std::erase_if(ended_, [](const auto& each) { return each.second.empty(); });
}

void KeptLogins::make_room() {
    std::size_t count = 0;
    Ended* most = nullptr;
    for (auto& [grant, ended] : ended_) {
        count += ended.size();
        if (most == nullptr || ended.size() > most->size())
            most = &ended;
    }
    if (count > most_ended)
        most->erase(std::min_element(most->begin(), most->end(), [](const auto& a, const auto& b) {
            return a.second < b.second;
        }));
}

std::string KeptLogins::text() const {
    std::string out;
    for (const auto& [grant, ended] : ended_)
        for (const auto& [id, made] : ended)
            out.append(grant.empty() ? token : grant)
                .append(" " + id + " " + std::to_string(made) + "\n");
    return out;
}

} // namespace wakesurf::server
