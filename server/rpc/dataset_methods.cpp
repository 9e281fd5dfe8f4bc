// dataset.list, dataset.describe, cache.status, probe.sample.
#include "protocol/checked_json.hpp"
#include "protocol/dataset_json.hpp"
#include "server/limits.hpp"
#include "server/rpc/cache_json.hpp"
#include "server/rpc/lattice_json.hpp"
#include "server/rpc/method_table.hpp"
#include "server/session/surface_rules.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void describe(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("dataset");
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto open = call.context.datasets.open(id);
    if (!open)
        return reply.fault(open.error());
    json out = protocol::dataset_json(open->info);
    out["lattice"] = lattice_json(open->lattice);
    out["surfaceFields"] = field_names(*open);
    reply.result(out);
}

void cache_status(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("dataset");
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto open = call.context.datasets.open(id);
    if (!open)
        return reply.fault(open.error());
    // A built-in flow has no time-steps, so none of them is anywhere.
    reply.result(
        cache_json(id, open->cache ? open->cache->status() : core::TimeStepCache::Status()));
}

json field_values(const ProbeField& field) {
    json values = json::array();
    for (const core::Vec3& v : field.vectors)
        values.push_back(core::finite(v) ? json{v.x, v.y, v.z} : json(nullptr));
    for (const float value : field.scalars)
        values.push_back(std::isfinite(value) ? json(value) : json(nullptr));
    return values;
}

void probe_sample(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("dataset");
    ProbeRequest request;
    request.points = in.points("points", limits::probe_points);
    request.time = in.number("time", std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::max());
    request.fields = in.texts_or_none("fields", limits::probe_fields);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    auto open = call.context.datasets.open(id);
    if (!open)
        return reply.fault(open.error());
    const auto answer = std::make_shared<Reply>(std::move(reply));
    call.context.prober.ask(
        std::move(*open), std::move(request), call.stop,
        [answer](const core::Result<ProbeResult>& result) {
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
    const Parameter dataset{"dataset", R"({"type":"string"})", true, "an id from dataset.list"};
    return {
        {"dataset.list",
         "The datasets this server serves.",
         {},
         "{datasets: [{dataset, name, state: ready, importing or failed, progress?, remaining?: "
         "seconds, steps: {ready, total}, error?}]}",
         any_viewer,
         [](const Call& call, Reply reply) {
             reply.result({{"datasets", call.context.list_datasets()}});
         }},
        {"dataset.describe",
         "Grid, times, fields and lattice of one dataset.",
         {dataset},
         "the shape of `wakesurf info --json`, and lattice: {origin, step, bits}, and "
         "surfaceFields: "
         "what `fields` of surface.set may name",
         any_viewer,
         describe},
        {"cache.status",
         "Which time-steps of a dataset are in memory.",
         {dataset},
         "{dataset, steps: [resident, loading or cold, ...], bytes, budget}; no steps for a "
         "built-in "
         "flow",
         any_viewer,
         cache_status},
        {"probe.sample",
         "Fields at points and one time, interpolated as the surfaces' vertices are.",
         {dataset,
          {"points",
           R"({"type":"array","items":{"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3}})",
           true, "where"},
          {"time", R"({"type":"number"})", true, "in the dataset's range"},
          {"fields", R"({"type":"array","items":{"type":"string"}})", false,
           "the velocity's name or scalars; left out: the velocity"}},
         "{values: {field: [number or [x, y, z] or null, ...]}, inside: [in the fluid?, ...]}",
         any_viewer,
         probe_sample},
    };
}

} // namespace wakesurf::server
