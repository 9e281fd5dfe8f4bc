#include "server/net/logins.hpp"

#include "server/base/limits.hpp"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace wakesurf::server {

namespace {

constexpr std::size_t id_digits = 32;
constexpr std::size_t longest_grant = 64;
constexpr std::string_view purpose = "wakesurf login 2\n";

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

/// Removes and returns the text up to the next dot, without the dot.
std::string_view next_part(std::string_view& text) {
    const auto end = std::min(text.find('.'), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end && value >= 0 ? std::optional(value) : std::nullopt;
}

} // namespace

std::string login_text(const SignedLogin& login, std::string_view key, const SecretDigest& secret) {
    const std::string said = login.id + "." + std::to_string(login.made) + "." +
                             std::to_string(login.renewed) + "." + login.grant;
    return said + "." + signature(std::string(purpose) + said + "\n" + digest_text(secret), key);
}

std::optional<SignedLogin> read_login(std::string_view text) {
    if (std::count(text.begin(), text.end(), '.') != 4)
        return std::nullopt;
    SignedLogin login;
    login.id = next_part(text);
    const auto made = whole_number(next_part(text));
    const auto renewed = whole_number(next_part(text));
    login.grant = next_part(text);
    const bool hexadecimal = login.id.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (login.id.size() != id_digits || !hexadecimal || !made || !renewed ||
        login.grant.size() > longest_grant)
        return std::nullopt;
    login.made = *made;
    login.renewed = *renewed;
    return login;
}

std::string Logins::make(const std::string& grant) {
    const std::int64_t now = services_.unix_time();
    return login_text({random_hex(services_.entropy, 16), now, now, grant}, services_.kept.key(),
                      services_.secret(grant).value_or(SecretDigest{}));
}

std::optional<std::string> Logins::renew(std::string_view text) {
    auto login = good(text);
    if (!login)
        return std::nullopt;
    login->renewed = services_.unix_time();
    return login_text(*login, services_.kept.key(),
                      services_.secret(login->grant).value_or(SecretDigest{}));
}

/// Returns a login that we signed for a secret that is still valid, even if it has ended or is too old.
std::optional<SignedLogin> Logins::sound(std::string_view text) const {
    const auto login = read_login(text);
    const auto secret = login ? services_.secret(login->grant) : std::nullopt;
    if (!secret || !same_digest(secret_digest(login_text(*login, services_.kept.key(), *secret)),
                                secret_digest(text)))
        return std::nullopt;
    return login;
}

std::optional<SignedLogin> Logins::good(std::string_view text) const {
    const auto login = sound(text);
    const std::int64_t now = services_.unix_time();
    if (!login || now - login->renewed >= limits::login_idle.count() ||
        now - login->made >= limits::login_most.count() || !lasts(login->grant, login->id))
        return std::nullopt;
    return login;
}

std::optional<Login> Logins::find(std::string_view text) const {
    const auto login = good(text);
    return login ? std::optional(Login{login->grant, login->id}) : std::nullopt;
}

std::optional<Login> Logins::end(std::string_view text, LoginStore::Done kept) {
    const auto login = sound(text);
    if (!login || !lasts(login->grant, login->id))
        return std::nullopt;
    services_.kept.end(login->grant, login->id, login->made, std::move(kept));
    return Login{login->grant, login->id};
}

bool Logins::lasts(const std::string& grant, const std::string& id) const {
    return !services_.kept.ended(grant, id);
}

} // namespace wakesurf::server
