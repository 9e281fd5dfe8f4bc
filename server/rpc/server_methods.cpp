// server.info, server.ping.
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json info() {
    return {{"name", "wakesurf"},
            {"version", WAKESURF_VERSION},
            {"apiLevel", 1},
            {"capabilities",
             {"stream", "path", "streak", "time", "mesh.vtp", "obstacle.bin", "lease", "history",
              "bookmark", "annotation"}},
            {"limits",
             {{"messageBytes", limits::message_bytes},
              {"batch", limits::batch},
              {"depth", limits::message_depth},
              {"sessions", limits::sessions},
              {"participants", limits::participants},
              {"rakes", limits::rakes},
              {"rakePoints", limits::rake_points},
              {"seeds", limits::seeds_most},
              {"surfaces", limits::surfaces},
              {"bookmarks", limits::bookmarks},
              {"annotations", limits::annotations},
              {"undo", limits::undo_steps},
              {"quads", limits::quads_most},
              {"waitMs", limits::wait_ms}}}};
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
    };
}

} // namespace wakesurf::server
