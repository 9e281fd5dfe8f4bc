// server.info, server.ping, server.stats.
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/server.hpp"
#include "protocol/api/openrpc.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Returns what a client may look for before it relies on it.
json capabilities() {
    json out{"stream", "path",     "streak", "time",  "obstacle.bin", "lease",
             "clock",  "history",  "slice",  "lines", "bookmark",     "annotation",
             "cancel", "progress", "stop",   "trash", "thumbnail",    "level"};
    for (const auto format : protocol::mesh_formats)
        out.push_back("mesh." + std::string(protocol::extension(format)));
    out.push_back("numbers.csv");
    out.push_back("animation.html");
    return out;
}

json quantiles_json(const Quantiles& quantiles) {
    return {{"p50", quantiles.p50},
            {"p95", quantiles.p95},
            {"p99", quantiles.p99},
            {"count", quantiles.count}};
}

json cache_json(const CacheStatus& cache) {
    return {{"dataset", cache.dataset},
            {"hits", cache.hits},
            {"loads", cache.loads},
            {"bytes", cache.bytes},
            {"budget", cache.budget}};
}

/// Returns what concerns those in one session, too.
json stages_json(const Metrics& metrics, std::size_t participants, std::size_t surfaces) {
    json stages = json::object();
    for (std::size_t i = 0; i < stage_names.size(); ++i)
        stages[std::string(stage_names[i])] =
            quantiles_json(metrics.quantiles(static_cast<Stage>(i)));
    return {{"participants", participants},
            {"surfaces", surfaces},
            {"stages", std::move(stages)},
            {"firstFrame", quantiles_json(metrics.first_frames())}};
}

json stats_json(const Metrics& metrics, const ServerStatus& status) {
    json uses = json::object();
    for (std::size_t i = 0; i < status.memory.by_use.size(); ++i)
        uses[std::string(core::name_of(static_cast<core::MemoryUse>(i)))] = status.memory.by_use[i];
    const ProcessMemory memory = process_memory();
    const Metrics::Totals totals = metrics.totals();
    json out = stages_json(metrics, status.participants, status.surfaces);
    out.update({{"uptime", status.uptime},
                {"connections", status.connections},
                {"clients", status.clients},
                {"sessions", status.sessions},
                {"cache", protocol::list_json(status.caches, cache_json)},
                {"memory",
                 {{"rss", memory.resident},
                  {"peak", memory.peak},
                  {"budget", status.memory.budget},
                  {"used", status.memory.used},
                  {"refused", status.memory.refused},
                  {"byUse", std::move(uses)}}},
                {"messages", totals.messages},
                {"frames", totals.frames},
                {"bytes", totals.frame_bytes + totals.message_bytes},
                {"keyframes", totals.keyframes},
                {"dropped", totals.dropped}});
    return out;
}

void server_info(const Call&, const protocol::ServerInfo&, Reply reply) {
    json limits = json::object();
    for (const auto& [name, value] : protocol::limits::told)
        limits[name] = value;
    reply.result({{"name", "wakesurf"},
                  {"version", WAKESURF_VERSION},
                  {"apiLevel", protocol::api_level},
                  {"capabilities", capabilities()},
                  {"limits", std::move(limits)}});
}

void server_ping(const Call&, const protocol::ServerPing&, Reply reply) {
    reply.result(json::object());
}

void server_stats(const Call& call, const protocol::ServerStats&, Reply reply) {
    if (call.context.metrics == nullptr || !call.context.status)
        return reply.fault({protocol::RpcCode::NotFound,
                            "this server keeps no statistics",
                            "`server.info` says what it offers",
                            {},
                            {}});
    if (call.identity.session.empty())
        return reply.result(stats_json(*call.context.metrics, call.context.status()));
    const auto session = call.context.sessions.find(call.identity.session);
    if (!session)
        return reply.fault(session.error());
    reply.result(stages_json(*call.context.metrics, (*session)->participants().present().size(),
                             (*session)->records().count(RecordType::Surface)));
}

} // namespace

std::vector<Method> server_methods() {
    return {method(server_info), method(server_ping), method(server_stats)};
}

} // namespace wakesurf::server
