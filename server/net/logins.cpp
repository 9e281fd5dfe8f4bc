#include "server/net/logins.hpp"

#include "server/base/limits.hpp"
#include "server/base/private_file.hpp"
#include "server/base/split.hpp"
#include "server/net/token_file.hpp"

#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace wakesurf::server {

namespace {

constexpr std::size_t id_digits = 32;
constexpr std::size_t longest_grant = 64;
constexpr std::string_view purpose = "wakesurf login 2\n";
constexpr const char* key_name = "login-key";
constexpr std::size_t longest_file = std::size_t{4} << 20;
const std::string no_link = "-"; ///< stands for the token

/// The file is made anew when it has this many lines more than twice those that are remembered.
constexpr std::size_t fewest_lines = 256;

std::string line_of(const std::string& grant, const std::string& id, std::int64_t made) {
    return (grant.empty() ? no_link : grant) + " " + id + " " + std::to_string(made) + "\n";
}

std::string signature(std::string_view text, std::string_view key) {
    SecretDigest mac{};
    unsigned length = 0;
    if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
             reinterpret_cast<const unsigned char*>(text.data()), text.size(),
             reinterpret_cast<unsigned char*>(mac.data()), &length) == nullptr ||
        length != mac.size())
        throw std::runtime_error("the system has no HMAC-SHA256");
    return digest_text(mac);
}

std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end && value >= 0 ? std::optional(value) : std::nullopt;
}

/// Parses a text without checking its signature; empty if it is malformed.
std::optional<Login> read_login(std::string_view text) {
    const auto parts = split(text, '.');
    if (parts.size() != 5)
        return std::nullopt;
    const std::string_view id = parts[0], grant = parts[3];
    const auto made = whole_number(parts[1]), renewed = whole_number(parts[2]);
    const bool hexadecimal = id.find_first_not_of("0123456789abcdef") == std::string_view::npos;
    if (id.size() != id_digits || !hexadecimal || !made || !renewed || grant.size() > longest_grant)
        return std::nullopt;
    return Login{std::string(id), *made, *renewed, std::string(grant)};
}

} // namespace

Logins::Logins(Entropy& entropy, UnixTime unix_time)
    : Logins(entropy, random_hex(entropy, 32), {}, std::move(unix_time)) {}

core::Result<Logins> Logins::open(const std::filesystem::path& folder,
                                  Entropy& entropy,
                                  Write write,
                                  UnixTime unix_time) {
    auto key = own_secret(folder / key_name, entropy, "the key of logins in the --state folder");
    if (!key)
        return tl::unexpected(key.error());
    Logins kept(entropy, std::move(*key), std::move(write), std::move(unix_time));
    const auto text = read_private_file(folder / ended_name, longest_file);
    if (!text && text.error().code != core::Error::Code::NotFound)
        return core::fail(text.error().code,
                          "the list of ended logins in the --state folder: " + text.error().message,
                          text.error().hint);
    kept.read(text.value_or(std::string()));
    return kept;
}

/// Signs by HMAC-SHA256 over the login and its secret: the text does not fit another token, or another link
/// of the same name. A subprotocol of a WebSocket can hold it.
std::string Logins::signed_text(const Login& login, const SecretDigest& secret) const {
    const std::string said = login.id + "." + std::to_string(login.made) + "." +
                             std::to_string(login.renewed) + "." + login.grant;
    return said + "." + signature(std::string(purpose) + said + "\n" + digest_text(secret), key_);
}

std::string Logins::make(const std::string& grant, const SecretDigest& secret) {
    const std::int64_t now = unix_time_();
    return signed_text({random_hex(entropy_, 16), now, now, grant}, secret);
}

std::string Logins::renew(Login login, const SecretDigest& secret) const {
    login.renewed = unix_time_();
    return signed_text(login, secret);
}

/// Returns a login that we signed for a secret that is still valid, and that has not been ended, even if it is
/// too old.
std::optional<Login> Logins::sound(std::string_view text, const Secrets& secrets) const {
    auto login = read_login(text);
    const auto secret = login ? secrets(login->grant) : std::nullopt;
    if (!secret || !same_digest(secret_digest(signed_text(*login, *secret)), secret_digest(text)) ||
        ended(login->grant, login->id))
        return std::nullopt;
    return login;
}

std::optional<Login> Logins::find(std::string_view text, const Secrets& secrets) const {
    auto login = sound(text, secrets);
    const std::int64_t now = unix_time_();
    if (login && (now - login->renewed >= limits::login_idle.count() ||
                  now - login->made >= limits::login_most.count()))
        login.reset();
    return login;
}

std::optional<Login> Logins::end(std::string_view text, const Secrets& secrets, Done kept) {
    auto login = sound(text, secrets);
    if (login)
        end(*login, std::move(kept));
    return login;
}

/// Damaged entries are left out, with a line in the log each.
void Logins::read(const std::string& text) {
    std::istringstream in(text);
    std::string line, grant, id;
    std::int64_t made = 0;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (words >> grant >> id >> made)
            add(grant == no_link ? std::string() : grant, id, made);
    }
    forget_expired();
}

bool Logins::ended(const std::string& grant, const std::string& id) const {
    const auto found = ended_.find(grant);
    return found != ended_.end() && found->second.made.contains(id);
}

void Logins::end(const Login& login, Done kept) {
    forget_expired();
    add(login.grant, login.id, login.made);
    make_room();
    if (!write_)
        return kept({});
    auto written = [this, kept = std::move(kept)](core::Result<void> done) {
        if (!done) {
            lines_.reset();
            spdlog::warn("event=logout_not_kept message=\"a login that ended may be valid again "
                         "after a restart\" reason=\"{}\"",
                         done.error().message);
        }
        kept(std::move(done));
    };
    const bool append = lines_ && *lines_ <= 2 * count_ + fewest_lines;
    lines_ = append ? *lines_ + 1 : count_;
    if (append)
        write_(To::Append, line_of(login.grant, login.id, login.made), std::move(written));
    else
        write_(To::Replace, text(), std::move(written));
}

void Logins::add(const std::string& grant, const std::string& id, std::int64_t made) {
    Ended& of = ended_[grant];
    if (!of.made.emplace(id, made).second)
        return;
    of.by_age.emplace(made, id);
    ++count_;
}

void Logins::Ended::forget_oldest() {
    made.erase(by_age.begin()->second);
    by_age.erase(by_age.begin());
}

/// Those are too old to be valid.
void Logins::forget_expired() {
    const std::int64_t oldest = unix_time_() - limits::login_most.count();
    for (auto each = ended_.begin(); each != ended_.end();) {
        Ended& of = each->second;
        for (; !of.by_age.empty() && of.by_age.begin()->first < oldest; --count_)
            of.forget_oldest();
        each = of.by_age.empty() ? ended_.erase(each) : std::next(each);
    }
}

void Logins::make_room() {
    if (count_ <= most_ended)
        return;
    std::ranges::max_element(ended_, {}, [](const auto& each) {
        return each.second.made.size();
    })->second.forget_oldest();
    --count_;
}

std::string Logins::text() const {
    std::string out;
    for (const auto& [grant, of] : ended_)
        for (const auto& [id, made] : of.made)
            out += line_of(grant, id, made);
    return out;
}

} // namespace wakesurf::server
