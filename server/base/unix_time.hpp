// The time that outlives a restart. It may jump when the clock is set, so that nothing is measured by it
// while the server runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

namespace wakesurf::server {

/// Returns seconds since 1970.
using UnixTime = std::function<std::int64_t()>;

/// Returns the machine's time.
inline std::int64_t unix_seconds() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::seconds>(now).count();
}

} // namespace wakesurf::server
