// Points in time as people and programs read them: RFC 3339, in UTC.
#pragma once

#include <cstdint>
#include <string>

namespace wakesurf::protocol {

/// Seconds since 1970 of the last second of the year 9999, the last that can be written.
inline constexpr std::int64_t last_utc_second = 253402300799;

/// `2026-11-22T10:47:40Z`. REQUIRES: 0 <= seconds since 1970 <= last_utc_second.
std::string utc_text(std::int64_t unix_seconds);

} // namespace wakesurf::protocol
