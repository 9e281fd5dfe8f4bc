// surface.wait, and $/cancelRequest, which ends it and every other call that is not answered yet.
#include "protocol/api/checked_json.hpp"
#include "protocol/api/json_text.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/outcome_json.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/rpc/work_progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// What somebody who waits would like to know: the newest state there is.
json look_at(const LiveSurface& live) {
    const SurfaceOutcome now = live.outcome();
    const char* phase = now.complete ? "final" : now.statistics.quads > 0 ? "coarse" : "computing";
    return {{"message", now.statistics.quads > 0
                            ? fmt::format("{}: {} quads", phase, now.statistics.quads)
                            : std::string(phase)},
            {"phase", phase},
            {"percentage", static_cast<int>(100.0 * live.fraction_done())},
            {"epoch", now.epoch},
            {"quads", now.statistics.quads},
            {"vertices", now.statistics.vertices}};
}

/// Alive from the call to its answer.
struct Waiting {
    explicit Waiting(Reply to) : reply(std::move(to)) {}

    Reply reply;
    Budgets::Place place;
    std::optional<WorkProgress> progress;
    std::optional<std::stop_callback<std::function<void()>>> cancelled;
};

void wait(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string surface = in.text("surface");
    const auto epoch = in.count_if("epoch", 0, std::numeric_limits<std::uint32_t>::max());
    const auto patience = in.count("timeoutMs", 0, limits::wait_ms);
    in.has("workDoneToken"); // read below
    const auto live = read_session(in, call).and_then(
        [&](const std::shared_ptr<Session>& session) { return session->live(surface); });
    if (!live)
        return reply.fault(live.error());
    const auto token = read_work_token(call);
    if (!token)
        return reply.fault(token.error());
    auto place = take(call, Use::Wait);
    if (!place)
        return reply.fault(place.error());
    const auto waiting = std::make_shared<Waiting>(std::move(reply));
    waiting->place = std::move(*place);
    const std::weak_ptr<LiveSurface> weak = *live;
    if (*token && call.client != nullptr)
        waiting->progress.emplace(call, **token, "waiting for surface " + surface, [weak] {
            const auto still = weak.lock();
            return still ? look_at(*still) : json::object();
        });
    const std::uint64_t ticket =
        (*live)->wait(epoch ? static_cast<std::uint32_t>(*epoch) : (*live)->epoch(),
                      std::chrono::milliseconds(patience),
                      [waiting](const core::Result<SurfaceOutcome>& outcome) {
                          waiting->progress.reset();
                          if (outcome)
                              waiting->reply.result(outcome_json(*outcome));
                          else
                              waiting->reply.fault(outcome.error());
                      });
    waiting->cancelled.emplace(call.stop, [weak, ticket] {
        if (const auto still = weak.lock())
            still->forget(ticket);
    });
}

void cancel(const Call& call, Reply reply) {
    const auto id = call.parameters.find("id");
    if (id == call.parameters.end() || !(id->is_string() || id->is_number()))
        return reply.fault({protocol::RpcCode::InvalidParameters,
                            "`id` must be the id of a call: a string or a number",
                            R"(as in {"id":7})",
                            {},
                            {}});
    call.client->calls().cancel(protocol::json_text(*id));
    reply.result(json::object());
}

} // namespace

std::vector<Method> wait_methods() {
    const char* text = R"({"type":"string"})";
    return {
        {"surface.wait",
         "Answers once the surface is complete.",
         {session_parameter(),
          {"surface", text, true, "an id from surface.list"},
          {"epoch", R"({"type":"integer","minimum":0})", false,
           "this one or a later one; left out: the current"},
          {"timeoutMs",
           fmt::format(R"({{"type":"integer","minimum":0,"maximum":{}}})", limits::wait_ms), true,
           "patience"},
          {"workDoneToken", R"({"type":["string","integer"]})", false,
           "on a WebSocket: $/progress with this token tells how far it is"}},
         "as surface.stats; complete is false when the time ran out",
         any_viewer,
         wait},
        {"$/cancelRequest",
         "A notification: answers an open call of this WebSocket with -32800 and stops its work. "
         "What an edit has "
         "changed stays changed.",
         {{"id", R"({"type":["string","number"]})", true, "of the call"}},
         "nothing",
         websocket_viewer,
         cancel},
    };
}

} // namespace wakesurf::server
