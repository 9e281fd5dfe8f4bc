#include "core/base/plain_text.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace wakesurf::core {

namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0; ///< 0: not UTF-8
};

/// The first character of a text that is not empty.
Character first_of(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    const std::size_t bytes = lead < 0x80             ? 1
                              : (lead & 0xe0) == 0xc0 ? 2
                              : (lead & 0xf0) == 0xe0 ? 3
                              : (lead & 0xf8) == 0xf0 ? 4
                                                      : 0;
    if (bytes == 0 || bytes > text.size())
        return {};
    constexpr std::array<unsigned, 5> bits{0, 0x7f, 0x1f, 0x0f, 0x07};
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    std::uint32_t code = lead & bits[bytes];
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return {};
        code = code << 6 | (byte(i) & 0x3f);
    }
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < least[bytes] || code > 0x10ffff || surrogate ? Character{}
                                                               : Character{code, bytes};
}

/// Unicode's controls, line ends, directions, joiners, fillers, variation selectors, private use, tags and
/// non-characters.
bool acts_or_hides(std::uint32_t code) {
    constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 19> ranges{{{0x00, 0x1f},
                                                                              {0x7f, 0x9f},
                                                                              {0xad, 0xad},
                                                                              {0x34f, 0x34f},
                                                                              {0x61c, 0x61c},
                                                                              {0x115f, 0x1160},
                                                                              {0x17b4, 0x17b5},
                                                                              {0x180b, 0x180f},
                                                                              {0x200b, 0x200f},
                                                                              {0x2028, 0x202e},
                                                                              {0x2060, 0x206f},
                                                                              {0x2800, 0x2800},
                                                                              {0x3164, 0x3164},
                                                                              {0xe000, 0xf8ff},
                                                                              {0xfe00, 0xfe0f},
                                                                              {0xfeff, 0xfeff},
                                                                              {0xffa0, 0xffa0},
                                                                              {0xfff0, 0xfffb},
                                                                              {0xe0000, 0x10ffff}}};
    for (const auto& [first, last] : ranges)
        if (code >= first && code <= last)
            return true;
    return (code & 0xfffe) == 0xfffe;
}

bool blank(std::uint32_t code) {
    return code == ' ' || code == '\t' || code == '\n' || code == '\r' || code == 0xa0 ||
           code == 0x1680 || (code >= 0x2000 && code <= 0x200a) || code == 0x2028 ||
           code == 0x2029 || code == 0x202f || code == 0x205f || code == 0x3000;
}

void add_hex(std::string& out, const char* start, std::uint32_t value, int digits) {
    out += start;
    for (int bit = 4 * (digits - 1); bit >= 0; bit -= 4)
        out += "0123456789abcdef"[value >> bit & 15];
}

/// Escapes as JSON does, so that JSON stays JSON.
void add_escaped(std::string& out, std::uint32_t code) {
    if (code < 0x10000)
        return add_hex(out, "\\u", code, 4);
    add_hex(out, "\\u", 0xd800 + ((code - 0x10000) >> 10), 4);
    add_hex(out, "\\u", 0xdc00 + (code & 0x3ff), 4);
}

std::string escaped(std::string_view text, bool lines) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const auto [code, bytes] = first_of(text);
        const bool stays = lines && (code == '\n' || code == '\t');
        if (bytes == 0)
            add_hex(out, "\\x", static_cast<unsigned char>(text.front()), 2);
        else if (acts_or_hides(code) && !stays)
            add_escaped(out, code);
        else
            out += text.substr(0, bytes);
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return out;
}

} // namespace

std::string display_name(std::string_view name, std::size_t longest) {
    std::string out;
    bool gap = false;
    while (!name.empty()) {
        const auto [code, bytes] = first_of(name);
        const std::string_view character = name.substr(0, bytes);
        name.remove_prefix(bytes == 0 ? 1 : bytes);
        if (bytes == 0)
            continue;
        if (blank(code)) {
            gap = !out.empty();
            continue;
        }
        if (acts_or_hides(code))
            continue;
        if (out.size() + (gap ? 1 : 0) + bytes > longest)
            break;
        if (std::exchange(gap, false))
            out += ' ';
        out += character;
    }
    return out;
}

std::string display_lines(std::string_view text, std::size_t longest) {
    std::string out;
    while (!text.empty()) {
        const auto [code, bytes] = first_of(text);
        const std::string_view character = text.substr(0, bytes);
        text.remove_prefix(bytes == 0 ? 1 : bytes);
        const bool stays = code == '\n' || code == '\t' || !acts_or_hides(code);
        if (bytes == 0 || !stays)
            continue;
        if (out.size() + bytes > longest)
            break;
        out += character;
    }
    return out;
}

std::string printable(std::string_view text) {
    return escaped(text, true);
}

std::string printable_line(std::string_view text) {
    return escaped(text, false);
}

} // namespace wakesurf::core
