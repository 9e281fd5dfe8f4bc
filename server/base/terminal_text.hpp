// What may be shown on a terminal of a text that we did not word ourselves, as names in a file that somebody else has made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Whatever a terminal could take for a command stands as \xHH: control characters, also those of two bytes, and what is not UTF-8.
inline std::string terminal_text(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto bytes_of = [](unsigned char lead) -> std::size_t {
        return lead < 0x80   ? 1
               : lead < 0xc2 ? 0
               : lead < 0xe0 ? 2
               : lead < 0xf0 ? 3
               : lead < 0xf5 ? 4
                             : 0;
    };
    std::string out;
    while (!text.empty()) {
        const auto lead = static_cast<unsigned char>(text[0]);
        const std::size_t bytes = bytes_of(lead);
        const std::string_view rest = text.substr(1, bytes == 0 ? 0 : bytes - 1);
        const bool whole = bytes > 0 && rest.size() == bytes - 1 &&
                           std::all_of(rest.begin(), rest.end(), [](char c) {
                               return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
                           });
        const bool control = lead < 0x20 || lead == 0x7f ||
                             (lead == 0xc2 && whole && static_cast<unsigned char>(rest[0]) < 0xa0);
        const std::size_t taken = whole ? bytes : 1;
        if (whole && !control)
            out += text.substr(0, taken);
        else
            for (const char c : text.substr(0, taken)) {
                const auto byte = static_cast<unsigned char>(c);
                out.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
            }
        text.remove_prefix(taken);
    }
    return out;
}

} // namespace wakesurf::server
