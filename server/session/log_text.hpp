// What may go into the log of an error we did not word ourselves: everything but paths of the server.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Words with a slash become `(path)`.
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
