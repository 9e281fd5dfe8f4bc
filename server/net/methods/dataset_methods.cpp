// dataset.list, dataset.describe, dataset.suggest, dataset.open, cache.status, probe.sample.
#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/api/generated/dataset.hpp"
#include "server/base/field_names.hpp"
#include "server/data/datasets.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/dataset_answers.hpp"
#include "server/net/methods/import_waiters.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/work_progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void dataset_list(const Call& call, const protocol::DatasetList&, Reply reply) {
    reply.result({{"datasets", call.context.list_datasets()}});
}

void dataset_describe(const Call& call, const protocol::DatasetDescribe& of, Reply reply) {
    const auto open = call.context.datasets.open(of.dataset);
    if (!open)
        return reply.fault(open.error());
    reply.made_result(call.context.answers->description(of.dataset, *open));
}

/// @param fields  for each of the surfaces
json suggestion_json(const core::SceneSuggestion& scene, const std::vector<std::string>& fields) {
    json surfaces = protocol::written(scene.surfaces);
    for (json& each : surfaces)
        each["fields"] = fields;
    return {{"rake", protocol::written(scene.rake)},
            {"surfaces", std::move(surfaces)},
            {"why", scene.why}};
}

/// Values of the old data are not told as the new data's.
core::Error replaced_meanwhile() {
    return {core::Error::Code::Io, "the data were replaced while this was looked up", "ask again"};
}

void dataset_suggest(const Call& call, const protocol::DatasetSuggest& of, Reply reply) {
    auto open = call.context.datasets.open(of.dataset);
    if (!open)
        return reply.fault(open.error());
    auto permit = take(call, Use::Probe);
    if (!permit)
        return reply.fault(permit.error());
    const auto answer = std::make_shared<Reply>(std::move(reply));
    std::vector<std::string> fields;
    if (has_interval_errors(open->info))
        fields.emplace_back(core::interval_error_name);
    call.context.prober.suggest(
        *open, Budgets::line(call.identity), call.stop,
        [answer, permit = std::move(*permit), &datasets = call.context.datasets, id = of.dataset,
         store = open->store, fields](const core::Result<core::SceneSuggestion>& scene) {
            if (replaced_since(datasets, id, store))
                return answer->fault(replaced_meanwhile());
            if (!scene)
                return answer->fault(scene.error());
            answer->result(suggestion_json(*scene, fields));
        });
}

json status_json(const DatasetStatus& status) {
    json out{{"message", fmt::format("{}: {} of {} time-steps", status.name, status.steps_ready,
                                     status.steps_total)},
             {"percentage", static_cast<int>(100.0 * status.progress)}};
    if (status.remaining)
        out["remaining"] = *status.remaining;
    return out;
}

/// Lives from the call to its answer.
struct Opening {
    explicit Opening(Reply to) : reply(std::move(to)) {}

    Reply reply;
    Budgets::Permit permit;
    std::optional<WorkProgress> progress;
    std::optional<std::stop_callback<std::function<void()>>> left;
};

void answer_opening(Opening& opening, const core::Result<DatasetStatus>& status) {
    opening.progress.reset();
    if (!status)
        return opening.reply.fault(status.error());
    if (status->state == DatasetState::Failed && status->error)
        return opening.reply.fault(*status->error);
    if (status->state == DatasetState::Stopped)
        return opening.reply.fault(core::Error{core::Error::Code::Cancelled,
                                               "the import of " + status->name + " was stopped",
                                               "`dataset.open` resumes the import"});
    opening.reply.result(dataset_entry(*status));
}

// A link's viewer may neither begin nor end what costs others so much; waiting costs nothing.
void dataset_open(const Call& call, const protocol::DatasetOpen& of, Reply reply) {
    const std::string& id = of.dataset;
    const auto token = work_token(call, of.work_done_token);
    ImportWaiters* const imports = call.context.imports;
    const bool editor = role_of(call) != Role::Viewer;
    if (!of.velocity.empty() && !editor)
        return reply.fault(protocol::RpcFault{protocol::RpcCode::NotPermitted,
                                              "a viewer may not choose the velocity of a dataset",
                                              "ask someone who may edit",
                                              {},
                                              {}});
    const auto there = core::fail(core::Error::Code::NotFound, "there is no dataset of this name");
    if (imports != nullptr && !of.velocity.empty())
        if (const auto chosen = imports->choose_velocity(id, of.velocity); !chosen)
            return reply.fault(chosen.error());
    const auto status =
        imports != nullptr ? imports->status(id) : core::Result<DatasetStatus>(there);
    if (!status)
        return reply.fault(status.error());
    auto permit = take(call, Use::Wait);
    if (!permit)
        return reply.fault(permit.error());
    const auto opening = std::make_shared<Opening>(std::move(reply));
    opening->permit = std::move(*permit);
    if (status->state == DatasetState::Stopped && !editor)
        return answer_opening(*opening, status);
    if (token && call.client != nullptr)
        opening->progress.emplace(call, *token, "opening " + status->name, [imports, id] {
            const auto now = imports->status(id);
            return now ? status_json(*now) : json::object();
        });
    // A notification has no answer: it begins an import, but waits for none.
    const bool unheard = call.client != nullptr && !call.stop.stop_possible();
    const std::uint64_t ticket = imports->wait(
        id, std::chrono::milliseconds(unheard ? 0 : of.timeout_ms),
        [opening](const core::Result<DatasetStatus>& now) { answer_opening(*opening, now); });
    if (ticket == 0)
        return;
    opening->left.emplace(call.stop, [imports, ticket, editor, cancelled = call.cancelled] {
        using Leaving = ImportWaiters::Leaving;
        imports->leave(ticket,
                       editor && cancelled.stop_requested() ? Leaving::AndStop : Leaving::Alone);
    });
}

void cache_status(const Call& call, const protocol::CacheStatus& of, Reply reply) {
    const auto open = call.context.datasets.open(of.dataset);
    if (!open)
        return reply.fault(open.error());
    // A built-in flow has no time-steps, so none of them is anywhere.
    reply.made_result(call.context.answers->cache(
        of.dataset, open->cache ? open->cache->status() : core::TimeStepCache::Status()));
}

json field_values(const ProbeField& field) {
    json values = json::array();
    for (const core::Vec3& v : field.vectors)
        values.push_back(core::finite(v) ? json{v.x, v.y, v.z} : json(nullptr));
    for (const float value : field.scalars)
        values.push_back(std::isfinite(value) ? json(value) : json(nullptr));
    return values;
}

void probe_sample(const Call& call, const protocol::ProbeSample& of, Reply reply) {
    ProbeRequest request;
    request.points = of.points;
    request.time = of.time;
    request.fields = of.fields;
    auto open = call.context.datasets.open(of.dataset);
    if (!open)
        return reply.fault(open.error());
    auto permit = take(call, Use::Probe);
    if (!permit)
        return reply.fault(permit.error());
    const auto answer = std::make_shared<Reply>(std::move(reply));
    call.context.prober.ask(
        *open, std::move(request), Budgets::line(call.identity), call.stop,
        [answer, permit = std::move(*permit), &datasets = call.context.datasets, id = of.dataset,
         store = open->store](const core::Result<ProbeResult>& result) {
            if (replaced_since(datasets, id, store))
                return answer->fault(replaced_meanwhile());
            if (!result)
                return answer->fault(result.error());
            json values = json::object();
            for (const ProbeField& field : result->fields)
                values[field.name] = field_values(field);
            answer->result({{"values", std::move(values)}, {"inside", result->inside}});
        });
}

} // namespace

std::vector<Method> dataset_methods() {
    return {method(dataset_list), method(dataset_describe), method(dataset_suggest),
            method(dataset_open), method(cache_status),     method(probe_sample)};
}

} // namespace wakesurf::server
