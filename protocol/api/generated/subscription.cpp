// Made by protocol/api/generate from subscription.schema.json: do not edit.
#include "protocol/api/generated/subscription.hpp"

#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, UpdatePlace& out) {
    out.epoch = static_cast<std::uint32_t>(in.count("epoch", 0, 4294967295));
    out.seq = static_cast<std::uint32_t>(in.count("seq", 0, 4294967295));
}

void read(CheckedJson& in, SurfaceStats& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
}

void read(CheckedJson& in, SurfaceWait& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
    if (const auto number = in.count_if("epoch", 0, 4294967295))
        out.epoch = static_cast<std::uint32_t>(*number);
    out.timeout_ms = in.count("timeoutMs", 0, limits::wait_ms);
    out.work_done_token = in.token_if("workDoneToken", true);
}

void read(CheckedJson& in, SurfaceSubscribe& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
    if (in.has("from")) {
        out.from.emplace();
        in.inside("from", [&](CheckedJson& inner) { read(inner, *out.from); });
    }
}

void read(CheckedJson& in, SurfaceUnsubscribe& out) {
    out.session = in.text_if("session", 256);
    if (const auto number = in.count_if("subscription", 0, 4294967295))
        out.subscription = static_cast<std::uint32_t>(*number);
    out.surface = in.text_if("surface", 256);
}

void read(CheckedJson& in, FrameAck& out) {
    out.subscription = static_cast<std::uint32_t>(in.count("subscription", 0, 4294967295));
    if (const auto number = in.count_if("epoch", 0, 4294967295))
        out.epoch = static_cast<std::uint32_t>(*number);
    out.seq = static_cast<std::uint32_t>(in.count("seq", 0, 4294967295));
}

nlohmann::json pass_seconds_json(const PassSeconds& record) {
    return {{"queue", record.queue},
            {"load", record.load},
            {"compute", record.compute},
            {"encode", record.encode}};
}

nlohmann::json terminations_json(const core::SurfaceStatistics::Terminated& record) {
    return {{"domain", record.domain},
            {"time", record.time},
            {"obstacle", record.obstacle},
            {"stagnation", record.stagnation},
            {"budget", record.budget}};
}

nlohmann::json build_seconds_json(const core::SurfaceStatistics::Seconds& record) {
    return {{"load", record.load},
            {"advect", record.advect},
            {"refine", record.refine},
            {"other", record.other},
            {"total", record.total}};
}

nlohmann::json emptiness_json(const core::Emptiness& record) {
    return {{"reason", name(record.reason)}, {"message", record.message}, {"hint", record.hint}};
}

nlohmann::json statistics_json(const core::SurfaceStatistics& record) {
    nlohmann::json out{{"kind", name(record.kind)},
                       {"quads", record.quads},
                       {"vertices", record.vertices},
                       {"steps", record.steps},
                       {"vertexSteps", record.vertex_steps},
                       {"approximated", record.approximated},
                       {"terminated", terminations_json(record.terminated)},
                       {"maxEdge", record.max_edge},
                       {"separation", record.separation},
                       {"requestedSeparation", record.requested_separation},
                       {"coarsened", record.coarsened()},
                       {"seconds", build_seconds_json(record.seconds)}};
    if (record.error)
        out["error99"] = record.error->error99;
    if (record.error)
        out["uncertain"] = record.error->uncertain;
    if (record.torn)
        out["torn"] = *record.torn;
    if (record.data_end)
        out["dataEnd"] = *record.data_end;
    if (record.field_range)
        out["fieldRange"] = *record.field_range;
    if (!record.stopped.empty())
        out["stopped"] = record.stopped;
    if (record.empty)
        out["empty"] = emptiness_json(*record.empty);
    return out;
}

nlohmann::json value_range_json(const core::ValueRange& record) {
    return {{"low", record.low},
            {"high", record.high},
            {"least", record.least},
            {"greatest", record.greatest}};
}

} // namespace wakesurf::protocol
