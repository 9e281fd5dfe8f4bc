#include "server/net/logins.hpp"

#include "server/base/limits.hpp"

namespace wakesurf::server {

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

std::optional<Login> Logins::end(std::string_view text, KeptLogins::Done kept) {
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
