// How a surface's epoch ended, as surface.stats, surface.wait and surface.done tell it.
#pragma once

#include "server/service/session/records/observer.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// {queue, load, compute, encode}
nlohmann::json pass_json(const PassSeconds& took);

/// [{attribute, low, high, least, greatest}]
nlohmann::json ranges_json(const ValueRanges& ranges);

nlohmann::json outcome_json(const SurfaceOutcome& outcome);

/// {code, message, kind, hint, limit?}
nlohmann::json error_json(const core::Error& error);

} // namespace wakesurf::server
