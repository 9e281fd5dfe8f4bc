// server.info, server.ping, server.stats.
#include "protocol/api/api_level.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/server.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/stats_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// What a client may look for before it relies on it.
json capabilities() {
    json out{"stream", "path",    "streak",    "time",       "obstacle.bin", "lease",
             "clock",  "history", "bookmark",  "annotation", "cancel",       "progress",
             "stop",   "trash",   "thumbnail", "level"};
    for (const auto format : protocol::mesh_formats)
        out.push_back("mesh." + std::string(protocol::extension(format)));
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
    if (call.context.metrics == nullptr || !call.context.standing)
        return reply.fault({protocol::RpcCode::NotFound,
                            "this server keeps no statistics",
                            "`server.info` says what it offers",
                            {},
                            {}});
    if (call.identity.session.empty())
        return reply.result(stats_json(*call.context.metrics, call.context.standing()));
    const auto session = call.context.sessions.find(call.identity.session);
    if (!session)
        return reply.fault(session.error());
    reply.result(stats_json(*call.context.metrics, **session));
}

} // namespace

std::vector<Method> server_methods() {
    return {method(server_info), method(server_ping), method(server_stats)};
}

} // namespace wakesurf::server
