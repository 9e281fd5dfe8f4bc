// Made by protocol/api/generate from surface.schema.json: do not edit.
#include "protocol/api/generated/surface.hpp"

#include "core/surface/request/surface_values.hpp"
#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, SurfaceRecord& out) {
    out.surface = in.some_text("surface", 256);
    out.rev = in.count("rev", 0, 9007199254740992);
    out.epoch = static_cast<std::uint32_t>(in.count("epoch", 0, 4294967295));
    out.rake = in.text("rake", 256);
    out.rake2 = in.text_if("rake2", 256);
    out.dataset = in.text("dataset", 256);
    in.word("kind", in.text("kind"), surface_kind, out.parameters.kind,
            "stream, path, streak, time or level");
    in.word("accuracy", in.text_or("accuracy", "balanced"), accuracy, out.parameters.accuracy,
            "fast, balanced or exact");
    in.word("interpolation", in.text_or("interpolation", "linear"), interpolation,
            out.parameters.interpolation, "linear or smooth");
    in.word("refine", in.text_or("refine", "on"), refine, out.parameters.refine, "on or off");
    out.parameters.to = in.number("to", -3.4028234663852886e+38, 3.4028234663852886e+38);
    out.parameters.release_until =
        in.number_if("releaseUntil", -3.4028234663852886e+38, 3.4028234663852886e+38);
    out.parameters.life = in.number_if("life", -any_number, any_number);
    if (out.parameters.life && !(*out.parameters.life > 0.0))
        in.fault("life", "must be a number greater than 0");
    out.parameters.sweep = in.point_if("sweep");
    out.parameters.field = in.text_if("field", 256);
    out.parameters.level = in.number_if("level", -any_number, any_number);
    out.parameters.merge = in.number_or("merge", 0.0, 0.5, 0.35);
    out.parameters.angle = in.number_or("angle", 0.0, 180.0, 20.0);
    if (in.has("angle") && !(out.parameters.angle > 0.0))
        in.fault("angle", "must be a number greater than 0");
    out.parameters.stagnation_speed = in.number_or("stagnationSpeed", 0.0, 0.1, 1e-06);
    out.parameters.max_quads =
        in.count_or("maxQuads", 1, limits::quads_most, limits::quads_default);
    out.parameters.from = in.number("from", -3.4028234663852886e+38, 3.4028234663852886e+38);
    if (in.has("direction"))
        in.word("direction", in.text("direction"), direction, out.parameters.direction,
                "forward, backward or both");
    out.parameters.separation = in.number_or("separation", 0.0, any_number, 0.0);
    out.fields = in.texts_or_none("fields", 16);
}

void read(CheckedJson& in, SurfaceSetting& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text_if("surface", 256);
    out.rake = in.text("rake", 256);
    out.rake2 = in.text_if("rake2", 256);
    out.dataset = in.text("dataset", 256);
    in.word("kind", in.text("kind"), surface_kind, out.parameters.kind,
            "stream, path, streak, time or level");
    out.from = in.number_if("from", -3.4028234663852886e+38, 3.4028234663852886e+38);
    out.parameters.to = in.number("to", -3.4028234663852886e+38, 3.4028234663852886e+38);
    if (in.has("direction"))
        in.word("direction", in.text("direction"), direction, out.parameters.direction,
                "forward, backward or both");
    in.word("accuracy", in.text_or("accuracy", "balanced"), accuracy, out.parameters.accuracy,
            "fast, balanced or exact");
    in.word("interpolation", in.text_or("interpolation", "linear"), interpolation,
            out.parameters.interpolation, "linear or smooth");
    in.word("refine", in.text_or("refine", "on"), refine, out.parameters.refine, "on or off");
    out.parameters.release_until =
        in.number_if("releaseUntil", -3.4028234663852886e+38, 3.4028234663852886e+38);
    out.parameters.life = in.number_if("life", -any_number, any_number);
    if (out.parameters.life && !(*out.parameters.life > 0.0))
        in.fault("life", "must be a number greater than 0");
    out.parameters.sweep = in.point_if("sweep");
    out.parameters.field = in.text_if("field", 256);
    out.parameters.level = in.number_if("level", -any_number, any_number);
    out.parameters.merge = in.number_or("merge", 0.0, 0.5, 0.35);
    out.parameters.angle = in.number_or("angle", 0.0, 180.0, 20.0);
    if (in.has("angle") && !(out.parameters.angle > 0.0))
        in.fault("angle", "must be a number greater than 0");
    out.parameters.stagnation_speed = in.number_or("stagnationSpeed", 0.0, 0.1, 1e-06);
    out.parameters.max_quads =
        in.count_or("maxQuads", 1, limits::quads_most, limits::quads_default);
    out.parameters.separation = in.number_or("separation", -any_number, any_number, 0.0);
    if (in.has("separation") && !(out.parameters.separation > 0.0))
        in.fault("separation", "must be a number greater than 0");
    out.fields = in.texts_or_none("fields", limits::fields);
    out.default_scene = in.flag_or("default", false);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

namespace {

core::SurfaceParameters with_rakes(const SurfaceSetting& setting) {
    core::SurfaceParameters out = setting.parameters;
    if (setting.rake2)
        out.rake2.emplace();
    return out;
}

} // namespace

core::Result<void> check_kind(const SurfaceSetting& setting) {
    if (auto fits = core::check_kind(with_rakes(setting)); !fits)
        return fits;
    if (setting.rake2 == setting.rake)
        return core::fail(core::Error::Code::InvalidArgument, "`rake2` is the rake itself",
                          "name another one");
    return {};
}

core::Result<void> check_rules(const SurfaceSetting& setting) {
    if (auto sound = check_kind(setting); !sound)
        return sound;
    return core::check_values(with_rakes(setting));
}

std::vector<std::pair<std::string_view, double>> given_numbers(const core::SurfaceParameters& p) {
    std::vector<std::pair<std::string_view, double>> out;
    if (p.release_until)
        out.emplace_back("releaseUntil", *p.release_until);
    if (p.life)
        out.emplace_back("life", *p.life);
    if (p.level)
        out.emplace_back("level", *p.level);
    return out;
}

void read(CheckedJson& in, SurfaceDelete& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, SurfaceStop& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
}

nlohmann::json record_json(const SurfaceRecord& record) {
    return kept_json(record);
}

nlohmann::json kept_json(const SurfaceRecord& record) {
    nlohmann::json out{{"surface", record.surface},
                       {"rev", record.rev},
                       {"epoch", record.epoch},
                       {"rake", record.rake},
                       {"dataset", record.dataset},
                       {"kind", name(record.parameters.kind)},
                       {"accuracy", name(record.parameters.accuracy)},
                       {"interpolation", name(record.parameters.interpolation)},
                       {"refine", name(record.parameters.refine)},
                       {"to", record.parameters.to},
                       {"merge", record.parameters.merge},
                       {"angle", record.parameters.angle},
                       {"stagnationSpeed", record.parameters.stagnation_speed},
                       {"maxQuads", record.parameters.max_quads},
                       {"from", record.parameters.from},
                       {"separation", record.parameters.separation},
                       {"fields", record.fields}};
    if (record.rake2)
        out["rake2"] = *record.rake2;
    if (record.parameters.release_until)
        out["releaseUntil"] = *record.parameters.release_until;
    if (record.parameters.life)
        out["life"] = *record.parameters.life;
    if (record.parameters.sweep)
        out["sweep"] = point_json(*record.parameters.sweep);
    if (record.parameters.field)
        out["field"] = *record.parameters.field;
    if (record.parameters.level)
        out["level"] = *record.parameters.level;
    if (record.parameters.direction)
        out["direction"] = name(*record.parameters.direction);
    return out;
}

} // namespace wakesurf::protocol
