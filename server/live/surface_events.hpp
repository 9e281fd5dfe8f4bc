// The events of a live surface as it is computed: progress, ranges of values, the outcome.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/surface_statistics.hpp"
#include "core/surface/value_range.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/wire/mesh_stream.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The range of one attribute of the frames.
struct AnnouncedRange {
    std::string attribute;
    core::ValueRange range;

    bool operator==(const AnnouncedRange&) const = default;
};

using ValueRanges = std::vector<AnnouncedRange>;

/// The time of one pass over a surface, stage by stage, as reported to clients.
using protocol::PassSeconds;

/// A surface has a state of a further phase.
struct SurfaceProgress {
    std::string surface;
    std::uint32_t epoch = 0;
    protocol::Phase phase = protocol::Phase::Final;
    PassSeconds took; ///< making that state
};

/// The ranges of a surface's values since it began to play.
struct SurfaceRanges {
    std::string surface;
    std::uint32_t epoch = 0;
    ValueRanges ranges;
};

/// The end of an epoch of a surface.
struct SurfaceOutcome {
    std::string surface;
    std::uint32_t epoch = 0;
    bool complete = false;
    /// The error between stored times is being estimated: the outcome comes once more.
    bool checks_pending = false;
    std::uint32_t state_sum = 0;
    core::SurfaceStatistics statistics; ///< of the newest state; all zero before the first
    std::optional<PassSeconds> took;    ///< making the newest state
    std::optional<core::Error> error;
};

} // namespace wakesurf::server
