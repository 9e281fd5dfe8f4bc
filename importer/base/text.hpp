// Texts: names that are compared whatever their case, numbers in file names and lists, notes for users.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::importer {

/// Returns the text with the letters of ASCII in lower case.
inline std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Returns the extension with its dot, in lower case: ".vtu".
std::string lower_extension(const std::filesystem::path& path);

/// Returns the whole text as a finite number, ignoring spaces around it; empty if it is none.
std::optional<double> finite_number(std::string_view text);

/// Returns the name without folder and last extension, and without _, - and dots before it: "flow" of
/// "flow_.vtu".
std::string tidy_name(std::string_view name);

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
