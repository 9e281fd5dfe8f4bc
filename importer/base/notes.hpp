// What a user should know of a dataset, one remark after the other.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace wakesurf::importer {

/// Adds `words` to `note` behind what it says already; nothing where they are empty.
inline void add_note(std::string& note, const std::string& words) {
    if (!words.empty())
        note += (note.empty() ? "" : "; ") + words;
}

/// A length for people, of so many digits: "0.25", "9.5e-07".
inline std::string length_text(double length, int digits = 3) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, length);
    return text.data();
}

} // namespace wakesurf::importer
