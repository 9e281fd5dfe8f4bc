// Values for lines of the log, `event=... key=value ...`. Foreign text may be logged without paths of the
// server, on one line, and cut to a length. Tokens, keys, cookies and messages are never logged.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Formats a value for a line: quoted unless it is one word, everything but printable ASCII as \xHH, at most
/// 80 characters of it.
inline std::string log_value(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    constexpr std::size_t most = 80;
    const auto plain = [](char c) {
        return c > ' ' && c < 0x7f && c != '"' && c != '\\' && c != '=';
    };
    if (!text.empty() && text.size() <= most && std::all_of(text.begin(), text.end(), plain))
        return std::string(text);
    std::string out = "\"";
    for (const char c : text.substr(0, most)) {
        const auto byte = static_cast<unsigned char>(c);
        if (plain(c) || c == ' ' || c == '=')
            out += c;
        else if (c == '"' || c == '\\')
            out.append(1, '\\').append(1, c);
        else
            out.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
    }
    return out + (text.size() > most ? "...\"" : "\"");
}

/// Replaces words with a slash by `(path)`.
inline std::string without_paths(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        out += word.find('/') == std::string_view::npos ? word : std::string_view("(path)");
        if (end < text.size())
            out += ' ';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

} // namespace wakesurf::server
