// dataset.list, dataset.describe.
#include "protocol/checked_json.hpp"
#include "protocol/dataset_json.hpp"
#include "server/rpc/lattice_json.hpp"
#include "server/rpc/method_table.hpp"

#include <nlohmann/json.hpp>

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
    reply.result(out);
}

} // namespace

std::vector<Method> dataset_methods() {
    return {
        {"dataset.list",
         "The datasets this server serves.",
         {},
         "{datasets: [{dataset, name, state: ready, importing or failed, progress?, steps: {ready, "
         "total}}]}",
         false,
         [](const Call& call, Reply reply) {
             reply.result({{"datasets", call.context.list_datasets()}});
         }},
        {"dataset.describe",
         "Grid, times, fields and lattice of one dataset.",
         {{"dataset", R"({"type":"string"})", true, "an id from dataset.list"}},
         "the shape of `wakesurf info --json`, and lattice: {origin, step, bits}",
         false,
         describe},
    };
}

} // namespace wakesurf::server
