// Notes for users about a dataset, one remark after the other.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace wakesurf::importer {

/// Appends `words` to `note`; does nothing if they are empty.
inline void add_note(std::string& note, const std::string& words) {
    if (!words.empty())
        note += (note.empty() ? "" : "; ") + words;
}

/// Returns a length for people, rounded to `digits` significant digits: "0.25", "9.5e-07".
inline std::string length_text(double length, int digits = 3) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, length);
    return text.data();
}

} // namespace wakesurf::importer
