#include "server/base/secret.hpp"

#include <openssl/crypto.h>
#include <sys/random.h>

#include <cerrno>
#include <stdexcept>
#include <vector>

namespace wakesurf::server {

void SystemEntropy::fill(std::span<std::byte> out) {
    while (!out.empty()) {
        const ssize_t got = ::getrandom(out.data(), out.size(), 0);
        if (got < 0 && errno != EINTR)
            throw std::runtime_error("the system provides no random numbers");
        if (got > 0)
            out = out.subspan(static_cast<std::size_t>(got));
    }
}

std::string random_hex(Entropy& entropy, std::size_t bytes) {
    std::vector<std::byte> raw(bytes);
    entropy.fill(raw);
    std::string text;
    for (const std::byte each : raw) {
        constexpr const char* digits = "0123456789abcdef";
        text += digits[std::to_integer<unsigned>(each >> 4)];
        text += digits[std::to_integer<unsigned>(each & std::byte{15})];
    }
    return text;
}

namespace {

constexpr std::string_view digits = "0123456789abcdef";

} // namespace

SecretDigest secret_digest(std::string_view secret) {
    Sha256 sum;
    sum.add(secret);
    return sum.digest();
}

bool same_digest(const SecretDigest& a, const SecretDigest& b) {
    return CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

std::optional<SecretDigest> read_digest(std::string_view text) {
    SecretDigest digest{};
    if (text.size() != 2 * digest.size())
        return std::nullopt;
    for (std::size_t i = 0; i < digest.size(); ++i) {
        const auto high = digits.find(text[2 * i]);
        const auto low = digits.find(text[2 * i + 1]);
        if (high == std::string_view::npos || low == std::string_view::npos)
            return std::nullopt;
        digest[i] = static_cast<std::byte>(high << 4 | low);
    }
    return digest;
}

} // namespace wakesurf::server
