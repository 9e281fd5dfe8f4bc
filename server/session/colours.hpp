// The colours of participants: those Okabe and Ito chose so that colour-blind people tell them apart ("Color Universal Design",
// 2008), without black, which is nobody's.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace wakesurf::server {

inline constexpr std::array<std::string_view, 7> participant_colours{
    "#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"};

/// #rrggbb
constexpr bool is_colour(std::string_view text) {
    const auto digit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text.size() == 7 && text.front() == '#' &&
           std::all_of(text.begin() + 1, text.end(), digit);
}

} // namespace wakesurf::server
