// A session besides its records, as it is kept and as a list of sessions tells of it: since when it is there,
// who was in it, whether anybody ever edited it, and whether it is in the trash.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Is somebody who was in a session; stays when the place, which can be come back to, is gone.
struct SessionPerson {
    std::string participant;
    std::string name;
    std::string colour; ///< #rrggbb

    bool operator==(const SessionPerson&) const = default;
};

/// Holds what is kept of it. Times are seconds since 1970.
struct SessionProfile {
    std::optional<std::int64_t> created; ///< nothing: kept by a wakesurf that did not note it
    std::int64_t last_used = 0;
    bool edited = false;                     ///< by anybody, beyond the page's default scene
    bool on_purpose = false;                 ///< somebody named, shared, copied or imported it
    std::vector<SessionPerson> people;       ///< who came last comes first
    std::optional<std::int64_t> deleted;     ///< in the trash since then
    std::map<std::string, std::string> data; ///< by dataset, which values its surfaces were of
    std::string copy_of = {};   ///< id of the session that it is a copy of; empty: none
    std::string copy_name = {}; ///< that this one had then

    bool operator==(const SessionProfile&) const = default;
};

/// Bounds how many people are remembered.
inline constexpr std::size_t most_session_people = 8;

/// Bounds of how many datasets the values are remembered.
inline constexpr std::size_t most_session_datasets = 32;

/// Returns JSON text.
std::string profile_text(const SessionProfile& profile);

/// Reads it back. Error: Corrupt.
core::Result<SessionProfile> read_profile(std::string_view text);

} // namespace wakesurf::protocol
