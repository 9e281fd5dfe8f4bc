// surface.stats, .recipe, .subscribe, .unsubscribe, frame.ack: what viewers of a surface ask of it.
#include "core/surface/playback/evolution.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/files/recipe.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/live/surface_file.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/dataset_answers.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/records_json.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace wakesurf::server {

using nlohmann::json;

namespace {

core::Result<std::shared_ptr<LiveSurface>>
find_live(const Call& call, const std::optional<std::string>& session, const std::string& surface) {
    return choose_session(call, session).and_then([&](const std::shared_ptr<Session>& found) {
        return found->live(surface);
    });
}

void surface_stats(const Call& call, const protocol::SurfaceStats& of, Reply reply) {
    const auto live = find_live(call, of.session, of.surface);
    if (!live)
        return reply.fault(live.error());
    reply.result(outcome_json((*live)->outcome()));
}

/// What the newest state was made from, if that is final.
void surface_recipe(const Call& call, const protocol::SurfaceRecipe& of, Reply reply) {
    const auto live = find_live(call, of.session, of.surface);
    if (!live)
        return reply.fault(live.error());
    const SurfaceOutcome outcome = (*live)->outcome();
    if (outcome.error)
        return reply.fault(*outcome.error);
    const SharedUpdate newest = (*live)->newest();
    if (!newest || newest->shape.empty())
        return reply.fault(core::Error{core::Error::Code::NotFound,
                                       "the newest state of " + of.surface + " is not final",
                                       "call `surface.wait` first"});
    const SurfaceJob& job = (*live)->wanted();
    const auto record = choose_session(call, of.session).and_then([&](const auto& session) {
        return session->records().template get<protocol::SurfaceRecord>(of.surface);
    });
    const auto data = record.and_then(
        [&](const auto& found) { return call.context.datasets.open(found.dataset); });
    if (!data)
        return reply.fault(data.error());
    protocol::Recipe recipe =
        recipe_of(job.plan, RecipeData{data->info.dataset, data->flow_text,
                                       job.store ? job.store->values() : std::string()});
    if (core::moves(recipe.parameters))
        recipe.time = newest->time;
    recipe.shape = newest->shape;
    reply.result({{"recipe", protocol::recipe_text(recipe)}, {"stateSum", newest->wire.state_sum}});
}

protocol::RpcFault no_subscription() {
    return {protocol::RpcCode::NotFound,
            "there is no such subscription",
            "`surface.subscribe` returns the number",
            {},
            {}};
}

void surface_subscribe(const Call& call, const protocol::SurfaceSubscribe& to, Reply reply) {
    const auto live = find_live(call, to.session, to.surface);
    if (!live)
        return reply.fault(live.error());
    if (call.batched) // frames could overtake the answer that says which surface they are of
        return reply.fault({protocol::RpcCode::InvalidRequest,
                            "`surface.subscribe` cannot be part of a batch",
                            "send it on its own",
                            {},
                            {}});
    json attributes = json::array();
    for (const std::string_view each : protocol::surface_attributes)
        attributes.push_back(each);
    for (const SurfaceField& each : (*live)->wanted().fields)
        attributes.push_back(each.name);
    std::optional<UpdatePosition> from;
    if (to.from)
        from = UpdatePosition{to.from->epoch, to.from->seq};
    FrameCursor cursor = call.client->cursor(to.surface, **live, from, call.context.metrics);
    if (!call.client->may_subscribe((*live)->number()))
        return reply.fault(core::Error{core::Error::Code::OverLimit,
                                       "the connection has reached its limit of subscriptions",
                                       "end some with `surface.unsubscribe`",
                                       {},
                                       protocol::limits::subscriptions});
    reply.result({{"subscription", (*live)->number()},
                  {"lattice", lattice_json((*live)->wanted().lattice)},
                  {"attributes", std::move(attributes)},
                  {"epoch", (*live)->epoch()},
                  {"resumed", cursor.resumed()},
                  {"ranges", ranges_json((*live)->ranges())}});
    call.client->subscribe(std::move(cursor), *live);
    (*live)->begin_now(); // it may have rested
}

void surface_unsubscribe(const Call& call, const protocol::SurfaceUnsubscribe& of, Reply reply) {
    std::optional<std::uint32_t> number = of.subscription;
    if (of.surface) {
        const auto live = find_live(call, of.session, *of.surface);
        if (!live)
            return reply.fault(live.error());
        number = (*live)->number();
    }
    if (!number)
        return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                       "`subscription` is missing",
                                       "give the number, or name the surface"});
    if (!call.client->unsubscribe(*number))
        return reply.fault(no_subscription());
    reply.result(json::object());
}

void surface_ack(const Call& call, const protocol::FrameAck& of, Reply reply) {
    if (!call.client->acknowledge(of.subscription, of.epoch, of.seq))
        return reply.fault(no_subscription());
    reply.result(json::object());
}

} // namespace

std::vector<Method> subscription_methods() {
    return {method(surface_stats), method(surface_recipe), method(surface_subscribe),
            method(surface_unsubscribe), method(surface_ack)};
}

} // namespace wakesurf::server
