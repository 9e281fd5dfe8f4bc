// What building a surface took and gave -> JSON: the one shape of `wakesurf surface --stats` and `surface.stats`.
#pragma once

#include "core/surface/surface_statistics.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace wakesurf::protocol {

/// Lengths in the dataset's unit, times in seconds of wall clock.
/// @param peak_bytes  the most memory that the process has held
nlohmann::json statistics_json(const core::SurfaceStatistics& statistics, std::uint64_t peak_bytes);

} // namespace wakesurf::protocol
