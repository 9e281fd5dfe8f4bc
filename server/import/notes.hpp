// What a user should know of a dataset, one remark after the other.
#pragma once

#include <string>

namespace wakesurf::server {

/// Adds `words` to `note` behind what it says already; nothing where they are empty.
inline void add_note(std::string& note, const std::string& words) {
    if (!words.empty())
        note += (note.empty() ? "" : "; ") + words;
}

} // namespace wakesurf::server
