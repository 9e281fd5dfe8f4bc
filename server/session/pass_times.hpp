// What one pass over a surface took, stage by stage, as the server counts it.
#pragma once

#include "core/surface/surface_statistics.hpp"
#include "server/metrics/metrics.hpp"

#include <algorithm>

namespace wakesurf::server {

/// Any thread. `queued`: seconds until a compute thread took it; `seconds`: until it was encoded, from then on.
inline void count_pass(Metrics* metrics,
                       double queued,
                       const core::SurfaceStatistics& statistics,
                       double seconds) {
    if (metrics == nullptr)
        return;
    const auto& spent = statistics.seconds;
    metrics->observe(Stage::Queue, queued);
    metrics->observe(Stage::Load, spent.load);
    metrics->observe(Stage::Advect, spent.advect);
    metrics->observe(Stage::Refine, spent.refine);
    metrics->observe(Stage::Encode, std::max(0.0, seconds - spent.total));
}

} // namespace wakesurf::server
