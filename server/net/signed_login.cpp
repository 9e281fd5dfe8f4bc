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
constexpr std::string_view purpose =
    "wakesurf login 2\n"; // 1 were cookies, which other ports have seen

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

} // namespace wakesurf::server
