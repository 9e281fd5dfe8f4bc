// Texts that are lists, cut at a separator.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Returns the parts of a text between separators: one more than there are of them.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at <= text.size(); at += out.back().size() + 1)
        out.push_back(text.substr(at, text.find(separator, at) - at));
    return out;
}

/// Returns the lines of a text that are not empty: names in an address, which may have commas.
inline std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> out;
    for (const std::string_view line : split(text, '\n'))
        if (!line.empty())
            out.emplace_back(line);
    return out;
}

} // namespace wakesurf::server
