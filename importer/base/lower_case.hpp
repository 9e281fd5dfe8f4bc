// Names of files, fields and patches are compared whatever their case.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace wakesurf::importer {

/// Returns the text with the letters of ASCII in lower case.
inline std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace wakesurf::importer
