#include "server/net/signed_login.hpp"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace wakesurf::server {

namespace {

constexpr std::size_t id_digits = 32;
constexpr std::size_t longest_grant = 64;
constexpr std::string_view purpose = "wakesurf login 1\n"; // the key may serve others one day

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

/// Up to the next dot, which goes as well.
std::string_view next_part(std::string_view& text) {
    const auto end = std::min(text.find('.'), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

} // namespace

std::string cookie_of(const SignedLogin& login, std::string_view key, const SecretDigest& secret) {
    const std::string said = login.id + "." + std::to_string(login.made) + "." + login.grant;
    return said + "." + signature(std::string(purpose) + said + "\n" + digest_text(secret), key);
}

std::optional<SignedLogin> read_cookie(std::string_view cookie) {
    if (std::count(cookie.begin(), cookie.end(), '.') != 3)
        return std::nullopt;
    SignedLogin login;
    login.id = next_part(cookie);
    const std::string_view made = next_part(cookie);
    login.grant = next_part(cookie);
    const auto* const end = made.data() + made.size();
    const auto [stop, error] = std::from_chars(made.data(), end, login.made);
    const bool hexadecimal = login.id.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (login.id.size() != id_digits || !hexadecimal || error != std::errc{} || stop != end ||
        login.made < 0 || login.grant.size() > longest_grant)
        return std::nullopt;
    return login;
}

} // namespace wakesurf::server
