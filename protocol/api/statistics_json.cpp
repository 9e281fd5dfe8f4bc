#include "protocol/api/statistics_json.hpp"

#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

nlohmann::json statistics_json(const core::SurfaceStatistics& statistics,
                               std::uint64_t peak_bytes) {
    const auto& ended = statistics.terminated;
    const auto& seconds = statistics.seconds;
    nlohmann::json out{{"kind", name(statistics.kind)},
                       {"quads", statistics.quads},
                       {"vertices", statistics.vertices},
                       {"steps", statistics.steps},
                       {"vertexSteps", statistics.vertex_steps},
                       {"approximated", statistics.approximated},
                       {"terminated",
                        {{"domain", ended.domain},
                         {"time", ended.time},
                         {"obstacle", ended.obstacle},
                         {"stagnation", ended.stagnation},
                         {"budget", ended.budget}}},
                       {"maxEdge", statistics.max_edge},
                       {"separation", statistics.separation},
                       {"requestedSeparation", statistics.requested_separation},
                       {"coarsened", statistics.coarsened()},
                       {"seconds",
                        {{"load", seconds.load},
                         {"advect", seconds.advect},
                         {"refine", seconds.refine},
                         {"other", seconds.other},
                         {"total", seconds.total}}},
                       {"peakBytes", peak_bytes}};
    if (statistics.torn)
        out["torn"] = *statistics.torn;
    if (statistics.data_end)
        out["dataEnd"] = *statistics.data_end;
    if (statistics.field_range)
        out["fieldRange"] = *statistics.field_range;
    if (statistics.empty)
        out["empty"] = {{"reason", name(statistics.empty->reason)},
                        {"message", statistics.empty->message},
                        {"hint", statistics.empty->hint}};
    if (statistics.error) {
        out["error99"] = statistics.error->error99;
        out["uncertain"] = statistics.error->uncertain;
    }
    if (!statistics.stopped.empty())
        out["stopped"] = statistics.stopped;
    return out;
}

} // namespace wakesurf::protocol
