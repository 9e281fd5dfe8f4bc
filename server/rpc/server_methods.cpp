// server.info, server.ping, server.stats.
#include "protocol/files/mesh_file.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/stats_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// What a client may look for before it relies on it.
json capabilities() {
    json out{"stream", "path",     "streak",  "time",     "obstacle.bin",
             "lease",  "clock",    "history", "bookmark", "annotation",
             "cancel", "progress", "stop",    "trash",    "thumbnail"};
    for (const auto format : protocol::mesh_formats)
        out.push_back("mesh." + std::string(protocol::extension(format)));
    return out;
}

json info() {
    return {{"name", "wakesurf"},
            {"version", WAKESURF_VERSION},
            {"apiLevel", 3},
            {"capabilities", capabilities()},
            {"limits",
             {{"messageBytes", limits::message_bytes},
              {"batch", limits::batch},
              {"depth", limits::message_depth},
              {"clients", limits::all.sockets},
              {"callsPerSecond", limits::person.calls},
              {"editsPerSecond", limits::person.edits},
              {"sessions", limits::kept_sessions},
              {"trash", limits::trash},
              {"thumbnailBytes", limits::thumbnail_bytes},
              {"participants", limits::participants},
              {"rakes", limits::rakes},
              {"rakePoints", limits::rake_points},
              {"seeds", limits::seeds_most},
              {"surfaces", limits::surfaces},
              {"bookmarks", limits::bookmarks},
              {"annotations", limits::annotations},
              {"sessionBytes", limits::session_bytes},
              {"undo", limits::undo_steps},
              {"shareLinks", limits::grants},
              {"subscriptions", limits::subscriptions},
              {"waiters", limits::waiters},
              {"pendingCalls", limits::pending_calls},
              {"probes", limits::person.probes},
              {"sockets", limits::person.sockets},
              {"downloads", limits::person.downloads},
              {"quads", limits::quads_most},
              {"fields", limits::fields},
              {"waitMs", limits::wait_ms}}}};
}

void stats(const Call& call, Reply reply) {
    if (call.context.metrics == nullptr || !call.context.standing)
        return reply.fault({protocol::RpcCode::NotFound,
                            "this server counts nothing",
                            "server.info says what it offers",
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
    return {
        {"server.info",
         "What this server is, what it offers, and what it grants.",
         {},
         "{name, version, apiLevel, capabilities, limits}",
         any_viewer,
         [](const Call&, Reply reply) { reply.result(info()); }},
        {"server.ping",
         "Answers at once: a client's heartbeat.",
         {},
         "{}",
         any_viewer,
         [](const Call&, Reply reply) { reply.result(json::object()); }},
        {"server.stats",
         "How long each stage from an edit to the socket took in the last minute, in seconds, and "
         "how the server stands; with a share link how its session does.",
         {},
         "{participants, surfaces, uptime, connections, clients, sessions, stages: {queue, load, "
         "advect, refine, encode, send: "
         "{p50, p95, p99, count}}, firstFrame, cache: [{dataset, hits, loads, bytes, budget}], "
         "memory: {rss, peak, budget, used, refused, byUse: {timeSteps, meshes, builds, surfaces, "
         "rings, "
         "histories, downloads, importers, records, messages, other}}, messages, "
         "frames, bytes, keyframes, dropped}; with a share link only participants, surfaces, "
         "stages and firstFrame",
         any_viewer,
         stats},
    };
}

} // namespace wakesurf::server
