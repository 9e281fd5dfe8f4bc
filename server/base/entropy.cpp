#include "server/base/entropy.hpp"

#include <sys/random.h>

#include <cerrno>
#include <stdexcept>
#include <vector>

namespace wakesurf::server {

void SystemEntropy::fill(std::span<std::byte> out) {
    while (!out.empty()) {
        const ssize_t got = ::getrandom(out.data(), out.size(), 0);
        if (got < 0 && errno != EINTR)
            throw std::runtime_error("the system has no random numbers to give");
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

} // namespace wakesurf::server
