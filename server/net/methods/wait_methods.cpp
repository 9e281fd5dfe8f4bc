// surface.wait, and $/cancelRequest, which ends it and every other call that is not answered yet.
#include "protocol/api/generated/server.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "server/base/forecast.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/records_json.hpp"
#include "server/net/methods/work_progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Returns what a waiting client is told: the newest state, and how far the work on a better one is.
json status_json(const LiveSurface& live, Forecast& forecast) {
    const SurfaceOutcome now = live.outcome();
    const BuildStatus status = live.status();
    const char* phase = now.complete ? "final" : now.statistics.quads > 0 ? "coarse" : "computing";
    forecast.add(status.seconds, status.fraction);
    json out{{"message", now.statistics.quads > 0
                             ? fmt::format("{}: {} quads", phase, now.statistics.quads)
                             : std::string(phase)},
             {"phase", phase},
             {"percentage", 100.0 * status.fraction},
             {"epoch", now.epoch},
             {"quads", now.statistics.quads},
             {"vertices", now.statistics.vertices},
             {"seconds", status.seconds}};
    if (now.complete)
        return out;
    if (status.time)
        out["time"] = *status.time;
    if (status.quads > 0)
        out["quadsSoFar"] = status.quads;
    if (const auto left = forecast.left())
        out["remaining"] = *left;
    return out;
}

/// Lives from the call to its answer.
struct Waiting {
    explicit Waiting(Reply to) : reply(std::move(to)) {}

    Reply reply;
    Budgets::Permit permit;
    std::optional<WorkProgress> progress;
    std::optional<std::stop_callback<std::function<void()>>> cancelled;
};

void surface_wait(const Call& call, const protocol::SurfaceWait& of, Reply reply) {
    const auto live =
        choose_session(call, of.session).and_then([&](const std::shared_ptr<Session>& session) {
            return session->live(of.surface);
        });
    if (!live)
        return reply.fault(live.error());
    const auto token = work_token(call, of.work_done_token);
    auto permit = take(call, Use::Wait);
    if (!permit)
        return reply.fault(permit.error());
    const auto waiting = std::make_shared<Waiting>(std::move(reply));
    waiting->permit = std::move(*permit);
    const std::weak_ptr<LiveSurface> weak = *live;
    if (token && call.client != nullptr)
        waiting->progress.emplace(call, *token, "waiting for surface " + of.surface,
                                  [weak, forecast = Forecast()]() mutable {
                                      const auto still = weak.lock();
                                      return still ? status_json(*still, forecast) : json::object();
                                  });
    const std::uint64_t ticket = (*live)->wait(
        of.epoch.value_or((*live)->epoch()), std::chrono::milliseconds(of.timeout_ms),
        [waiting](const core::Result<SurfaceOutcome>& outcome) {
            waiting->progress.reset();
            if (outcome)
                waiting->reply.result(outcome_json(*outcome));
            else
                waiting->reply.fault(outcome.error());
        },
        of.checked.value_or(false));
    waiting->cancelled.emplace(call.stop, [weak, ticket] {
        if (const auto still = weak.lock())
            still->forget(ticket);
    });
}

void cancel_request(const Call& call, const protocol::CancelRequest& of, Reply reply) {
    call.client->calls().cancel(of.id);
    reply.result(json::object());
}

} // namespace

std::vector<Method> wait_methods() {
    return {method(surface_wait), method(cancel_request)};
}

} // namespace wakesurf::server
