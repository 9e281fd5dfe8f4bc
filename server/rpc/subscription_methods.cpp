// surface.stats, .subscribe, .unsubscribe: what those who look at a surface ask of it.
#include "protocol/checked_json.hpp"
#include "protocol/mesh_encoder.hpp"
#include "server/rpc/lattice_json.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/outcome_json.hpp"
#include "server/rpc/session_choice.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Reads `surface` and `session`.
core::Result<std::shared_ptr<LiveSurface>> read_live(protocol::CheckedJson& in, const Call& call) {
    const std::string surface = in.text("surface");
    return read_session(in, call).and_then(
        [&](const std::shared_ptr<Session>& session) { return session->live(surface); });
}

void stats(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto live = read_live(in, call);
    if (!live)
        return reply.fault(live.error());
    reply.result(outcome_json((*live)->outcome()));
}

void subscribe(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto live = read_live(in, call);
    if (!live)
        return reply.fault(live.error());
    if (call.batched) // frames could overtake the answer that says which surface they are of
        return reply.fault({protocol::RpcCode::InvalidRequest,
                            "surface.subscribe cannot be part of a batch",
                            "send it on its own",
                            {},
                            {}});
    json attributes = json::array();
    for (const std::string_view each : protocol::surface_attributes)
        attributes.push_back(each);
    reply.result({{"subscription", (*live)->number()},
                  {"lattice", lattice_json((*live)->wanted().lattice)},
                  {"attributes", std::move(attributes)},
                  {"epoch", (*live)->epoch()}});
    call.client->subscribe(*live);
}

void unsubscribe(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    std::optional<std::uint64_t> number =
        in.count_if("subscription", 0, std::numeric_limits<std::uint32_t>::max());
    if (in.has("surface")) {
        const auto live = read_live(in, call);
        if (!live)
            return reply.fault(live.error());
        number = (*live)->number();
    } else if (!number) {
        in.fault("subscription", "is missing");
    }
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    if (!call.client->unsubscribe(static_cast<std::uint32_t>(*number)))
        return reply.fault({protocol::RpcCode::NotFound,
                            "there is no such subscription",
                            "surface.subscribe gives the number",
                            {},
                            {}});
    reply.result(json::object());
}

} // namespace

std::vector<Method> subscription_methods() {
    const char* text = R"({"type":"string"})";
    const char* whole = R"({"type":"integer","minimum":0})";
    const Parameter surface{"surface", text, true, "an id from surface.list"};
    const Parameter session = session_parameter();
    return {
        {"surface.stats",
         "What the newest state of a surface is and took.",
         {session, surface},
         "the shape of `--stats`, and surface, epoch, complete, crc",
         any_viewer,
         stats},
        {"surface.subscribe",
         "Sends the mesh of a surface, now and after every change, as binary frames.",
         {session, surface},
         "{subscription, lattice, attributes, epoch}",
         websocket_viewer,
         subscribe},
        {"surface.unsubscribe",
         "Ends a subscription.",
         {session,
          {"subscription", whole, false, "the number, or name the surface"},
          {"surface", text, false, "instead of the number"}},
         "{}",
         websocket_viewer,
         unsubscribe},
    };
}

} // namespace wakesurf::server
