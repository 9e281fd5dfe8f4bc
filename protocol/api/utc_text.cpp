#include "protocol/api/utc_text.hpp"

#include <fmt/chrono.h>

#include <ctime>

namespace wakesurf::protocol {

std::string utc_text(std::int64_t unix_seconds) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z",
                       fmt::gmtime(static_cast<std::time_t>(unix_seconds)));
}

} // namespace wakesurf::protocol
