#include "protocol/files/base64.hpp"

#include <algorithm>
#include <cstdint>

namespace wakesurf::protocol {

namespace {

constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace

void append_base64(std::string& out, std::string_view bytes) {
    out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= count ? letters[three >> (18 - 6 * k) & 63u] : '=';
    }
}

bool is_base64(char letter) {
    return letter == '=' || letters.find(letter) != std::string_view::npos;
}

std::optional<std::string> base64_bytes(std::string_view text) {
    if (text.size() % 4 != 0)
        return std::nullopt;
    std::string out;
    out.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        std::uint32_t three = 0;
        std::size_t count = 3;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t value = letters.find(text[i + k]);
            if (value == std::string_view::npos)
                count = std::min<std::size_t>(count, k == 0 ? 0 : k - 1);
            else if (count < 3)
                return std::nullopt; // a letter behind padding
            three = three << 6 | static_cast<std::uint32_t>(value & 63u);
        }
        if (count == 0)
            return std::nullopt;
        for (std::size_t k = 0; k < count; ++k)
            out += static_cast<char>(three >> (16 - 8 * k));
    }
    std::string again;
    append_base64(again, out);
    return again == text ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace wakesurf::protocol
