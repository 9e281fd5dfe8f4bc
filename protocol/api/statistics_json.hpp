// What building a surface took and gave -> JSON: the one shape of `wakesurf surface --stats` and `surface.stats`.
#pragma once

#include "core/surface/surface_statistics.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::protocol {

/// Lengths in the dataset's unit, times in seconds of wall clock, sizes in bytes.
nlohmann::json statistics_json(const core::SurfaceStatistics& statistics);

} // namespace wakesurf::protocol
