// Colours, as they are written in messages and records.
#pragma once

#include <algorithm>
#include <string_view>

namespace wakesurf::protocol {

/// #rrggbb
constexpr bool is_colour(std::string_view text) {
    const auto digit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text.size() == 7 && text.front() == '#' &&
           std::all_of(text.begin() + 1, text.end(), digit);
}

} // namespace wakesurf::protocol
