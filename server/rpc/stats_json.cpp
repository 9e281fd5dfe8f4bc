#include "server/rpc/stats_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json quantiles_json(const Quantiles& quantiles) {
    return {{"p50", quantiles.p50},
            {"p95", quantiles.p95},
            {"p99", quantiles.p99},
            {"count", quantiles.count}};
}

json stages_json(const Metrics& metrics) {
    json stages = json::object();
    for (std::size_t i = 0; i < stage_names.size(); ++i)
        stages[std::string(stage_names[i])] =
            quantiles_json(metrics.quantiles(static_cast<Stage>(i)));
    return stages;
}

} // namespace

json stats_json(const Metrics& metrics, Session& session) {
    return {{"participants", session.participants().present().size()},
            {"surfaces", session.surfaces().size()},
            {"stages", stages_json(metrics)},
            {"firstFrame", quantiles_json(metrics.first_frames())}};
}

json stats_json(const Metrics& metrics, const Standing& standing) {
    json caches = json::array();
    for (const CacheStanding& each : standing.caches)
        caches.push_back({{"dataset", each.dataset},
                          {"hits", each.hits},
                          {"loads", each.loads},
                          {"bytes", each.bytes},
                          {"budget", each.budget}});
    json uses = json::object();
    for (std::size_t i = 0; i < standing.memory.by_use.size(); ++i)
        uses[std::string(core::name_of(static_cast<core::MemoryUse>(i)))] =
            standing.memory.by_use[i];
    const ProcessMemory memory = process_memory();
    const Metrics::Totals totals = metrics.totals();
    return {{"uptime", standing.uptime},
            {"connections", standing.connections},
            {"clients", standing.clients},
            {"sessions", standing.sessions},
            {"participants", standing.participants},
            {"surfaces", standing.surfaces},
            {"stages", stages_json(metrics)},
            {"firstFrame", quantiles_json(metrics.first_frames())},
            {"cache", std::move(caches)},
            {"memory",
             {{"rss", memory.resident},
              {"peak", memory.peak},
              {"budget", standing.memory.budget},
              {"used", standing.memory.used},
              {"refused", standing.memory.refused},
              {"byUse", std::move(uses)}}},
            {"messages", totals.messages},
            {"frames", totals.frames},
            {"bytes", totals.frame_bytes + totals.message_bytes},
            {"keyframes", totals.keyframes},
            {"dropped", totals.dropped}};
}

} // namespace wakesurf::server
