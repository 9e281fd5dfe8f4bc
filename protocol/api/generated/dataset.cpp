// Made by protocol/api/generate from dataset.schema.json: do not edit.
#include "protocol/api/generated/dataset.hpp"

#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, DatasetDescribe& out) {
    out.dataset = in.text("dataset", 256);
}

void read(CheckedJson& in, DatasetOpen& out) {
    out.dataset = in.text("dataset", 256);
    out.timeout_ms = in.count_or("timeoutMs", 0, limits::wait_ms, limits::wait_ms);
    out.velocity = in.text_or("velocity", "", 256);
    out.work_done_token = in.token_if("workDoneToken", true);
}

void read(CheckedJson& in, DatasetSuggest& out) {
    out.dataset = in.text("dataset", 256);
}

void read(CheckedJson& in, CacheStatus& out) {
    out.dataset = in.text("dataset", 256);
}

void read(CheckedJson& in, ProbeSample& out) {
    out.dataset = in.text("dataset", 256);
    out.points = in.points("points", limits::probe_points);
    out.time = in.number("time", -any_number, any_number);
    out.fields = in.texts_or_none("fields", limits::probe_fields);
}

nlohmann::json suggested_surface_json(const core::SurfaceParameters& record) {
    nlohmann::json out{{"kind", name(record.kind)},
                       {"from", record.from},
                       {"to", record.to},
                       {"separation", record.separation}};
    if (record.sweep)
        out["sweep"] = point_json(*record.sweep);
    return out;
}

nlohmann::json suggested_rake_json(const core::Rake& record) {
    return {{"kind", name(record.kind)},
            {"points", points_json(record.points)},
            {"seeds", record.seeds}};
}

} // namespace wakesurf::protocol
