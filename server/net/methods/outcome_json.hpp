// The end of a surface's epoch, as surface.stats, surface.wait and surface.done tell it. Names of shapes
// are those of the description of the API.
#pragma once

#include "server/sessions/records/observer.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// Returns an array of ValueRange.
nlohmann::json ranges_json(const ValueRanges& ranges);

/// Returns a Statistics.
nlohmann::json outcome_json(const SurfaceOutcome& outcome);

/// Returns a Problem.
nlohmann::json error_json(const core::Error& error);

} // namespace wakesurf::server
