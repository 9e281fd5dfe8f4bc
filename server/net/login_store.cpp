#include "server/net/login_store.hpp"

#include "server/base/limits.hpp"
#include "server/base/private_file.hpp"
#include "server/net/token_file.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr const char* key_name = "login-key";
constexpr std::size_t longest_file = std::size_t{4} << 20;
const std::string token = "-"; ///< stands for a link

/// The file is made anew when it has this many lines more than twice those that are remembered.
constexpr std::size_t fewest_lines = 256;

std::string line_of(const std::string& grant, const std::string& id, std::int64_t made) {
    return (grant.empty() ? token : grant) + " " + id + " " + std::to_string(made) + "\n";
}

} // namespace

LoginStore::LoginStore(Entropy& entropy, UnixTime unix_time)
    : LoginStore(random_hex(entropy, 32), {}, std::move(unix_time)) {}

core::Result<LoginStore> LoginStore::open(const std::filesystem::path& folder,
                                          Entropy& entropy,
                                          Write write,
                                          UnixTime unix_time) {
    auto key = own_secret(folder / key_name, entropy, "the key of logins in the --state folder");
    if (!key)
        return tl::unexpected(key.error());
    LoginStore kept(std::move(*key), std::move(write), std::move(unix_time));
    const auto text = read_private_file(folder / ended_name, longest_file);
    if (!text && text.error().code != core::Error::Code::NotFound)
        return core::fail(text.error().code,
                          "the list of ended logins in the --state folder: " + text.error().message,
                          text.error().hint);
    kept.read(text.value_or(std::string()));
    return kept;
}

/// Damaged entries are left out, with a line in the log each.
void LoginStore::read(const std::string& text) {
    std::istringstream in(text);
    std::string line, grant, id;
    std::int64_t made = 0;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (words >> grant >> id >> made)
            add(grant == token ? std::string() : grant, id, made);
    }
    forget_expired();
}

bool LoginStore::ended(const std::string& grant, const std::string& id) const {
    const auto found = ended_.find(grant);
    return found != ended_.end() && found->second.made.contains(id);
}

void LoginStore::end(const std::string& grant,
                     const std::string& id,
                     std::int64_t made,
                     Done done) {
    forget_expired();
    add(grant, id, made);
    make_room();
    if (!write_)
        return done({});
    auto written = [this, done = std::move(done)](core::Result<void> kept) {
        if (!kept) {
            lines_.reset();
            spdlog::warn("event=logout_not_kept message=\"a login that ended may be valid again "
                         "after a restart\" reason=\"{}\"",
                         kept.error().message);
        }
        done(std::move(kept));
    };
    const bool append = lines_ && *lines_ <= 2 * count_ + fewest_lines;
    lines_ = append ? *lines_ + 1 : count_;
    if (append)
        write_(To::Append, line_of(grant, id, made), std::move(written));
    else
        write_(To::Replace, text(), std::move(written));
}

void LoginStore::add(const std::string& grant, const std::string& id, std::int64_t made) {
    Ended& of = ended_[grant];
    if (!of.made.emplace(id, made).second)
        return;
    of.by_age.emplace(made, id);
    ++count_;
}

void LoginStore::Ended::forget_oldest() {
    made.erase(by_age.begin()->second);
    by_age.erase(by_age.begin());
}

/// Those are too old to be valid.
void LoginStore::forget_expired() {
    const std::int64_t oldest = unix_time_() - limits::login_most.count();
    for (auto each = ended_.begin(); each != ended_.end();) {
        Ended& of = each->second;
        for (; !of.by_age.empty() && of.by_age.begin()->first < oldest; --count_)
            of.forget_oldest();
        each = of.by_age.empty() ? ended_.erase(each) : std::next(each);
    }
}

void LoginStore::make_room() {
    if (count_ <= most_ended)
        return;
    std::ranges::max_element(ended_, {}, [](const auto& each) {
        return each.second.made.size();
    })->second.forget_oldest();
    --count_;
}

std::string LoginStore::text() const {
    std::string out;
    for (const auto& [grant, of] : ended_)
        for (const auto& [id, made] : of.made)
            out += line_of(grant, id, made);
    return out;
}

} // namespace wakesurf::server
