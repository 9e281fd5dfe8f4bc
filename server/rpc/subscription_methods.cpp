// surface.stats, .subscribe, .unsubscribe, frame.ack: what those who look at a surface ask of it.
#include "protocol/api/checked_json.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/limits.hpp"
#include "server/rpc/lattice_json.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/outcome_json.hpp"
#include "server/rpc/session_choice.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();

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

protocol::RpcFault no_subscription() {
    return {protocol::RpcCode::NotFound,
            "there is no such subscription",
            "surface.subscribe returns the number",
            {},
            {}};
}

/// Reads `from`, a place among a surface's updates.
core::Result<std::optional<UpdatePosition>> read_position(protocol::CheckedJson& in,
                                                          const Call& call) {
    if (!in.has("from"))
        return std::nullopt;
    protocol::CheckedJson position(call.parameters.at("from"));
    const auto epoch = position.count("epoch", 0, most);
    const auto seq = position.count("seq", 0, most);
    return position.verdict().map([&] {
        return std::optional(
            UpdatePosition{static_cast<std::uint32_t>(epoch), static_cast<std::uint32_t>(seq)});
    });
}

void subscribe(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string surface = in.text("surface");
    const auto from = read_position(in, call);
    if (!from)
        return reply.fault(from.error());
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
    for (const SurfaceField& each : (*live)->wanted().fields)
        attributes.push_back(each.name);
    FrameCursor cursor = call.client->cursor(surface, **live, *from, call.context.metrics);
    if (!call.client->may_subscribe((*live)->number()))
        return reply.fault(core::Error{core::Error::Code::OverLimit,
                                       "the connection has as many subscriptions as it may have",
                                       "end some with surface.unsubscribe",
                                       {},
                                       limits::subscriptions});
    reply.result({{"subscription", (*live)->number()},
                  {"lattice", lattice_json((*live)->wanted().lattice)},
                  {"attributes", std::move(attributes)},
                  {"epoch", (*live)->epoch()},
                  {"resumed", cursor.resumed()}});
    call.client->subscribe(std::move(cursor));
    (*live)->begin_now(); // it may have rested
}

void unsubscribe(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    std::optional<std::uint64_t> number = in.count_if("subscription", 0, most);
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
        return reply.fault(no_subscription());
    reply.result(json::object());
}

void acknowledge(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto number = static_cast<std::uint32_t>(in.count("subscription", 0, most));
    const auto epoch = in.count_if("epoch", 0, most);
    const auto seq = static_cast<std::uint32_t>(in.count("seq", 0, most));
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto of = epoch ? std::optional(static_cast<std::uint32_t>(*epoch)) : std::nullopt;
    if (!call.client->acknowledge(number, of, seq))
        return reply.fault(no_subscription());
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
         {session,
          surface,
          {"from",
           R"({"type":"object","properties":{"epoch":{"type":"integer"},"seq":{"type":"integer"}},"required":["epoch","seq"]})",
           false, "the newest update folded before a lost connection: go on after it if possible"}},
         "{subscription, lattice, attributes, epoch, resumed}: resumed is false when a keyframe "
         "comes",
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
        {"frame.ack",
         "Says up to which update a subscription's frames have been folded. Who does so is "
         "sent at "
         "most eight updates more than that; meant as a notification.",
         {{"subscription", whole, true, "the number"},
          {"epoch", whole, false, "left out: the surface's current one"},
          {"seq", whole, true, "of the update"}},
         "{}",
         websocket_viewer,
         acknowledge},
    };
}

} // namespace wakesurf::server
