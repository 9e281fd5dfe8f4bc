#include "protocol/api/messages_surface.hpp"

#include "protocol/api/surface_names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace wakesurf::protocol {

namespace {

constexpr double any = std::numeric_limits<double>::max();
/// Times must stay finite as float, in which attributes travel.
constexpr double any_time = std::numeric_limits<float>::max();
constexpr std::size_t fields_once_allowed = 16;

core::SurfaceParameters read_parameters(CheckedJson& in, const SurfaceLimits& limits) {
    core::SurfaceParameters out;
    if (const auto kind = surface_kind(in.text("kind")))
        out.kind = *kind;
    else
        in.fault("kind", "must be stream, path, streak or time");
    if (const auto found = direction(in.text_or("direction", "forward")))
        out.direction = *found;
    else
        in.fault("direction", "must be forward, backward or both");
    if (const auto found = accuracy(in.text_or("accuracy", "balanced")))
        out.accuracy = *found;
    else
        in.fault("accuracy", "must be fast, balanced or exact");
    out.from = in.number("from", -any_time, any_time);
    out.to = in.number("to", -any_time, any_time);
    out.release_until = in.number_if("releaseUntil", -any_time, any_time);
    out.sweep = in.point_if("sweep");
    out.merge = in.number_or("merge", 0.0, 0.5, out.merge);
    out.angle = in.number_or("angle", 0.0, 180.0, out.angle);
    out.separation = in.number_or("separation", 0.0, any, 0.0);
    out.max_quads = in.count_or("maxQuads", 1, limits.quads_most, limits.quads_default);
    return out;
}

} // namespace

SurfaceSetting read_surface_setting(CheckedJson& in, const SurfaceLimits& limits) {
    SurfaceSetting setting;
    if (in.has("surface"))
        setting.surface = in.text("surface");
    setting.rake = in.text("rake");
    if (in.has("rake2"))
        setting.rake2 = in.text("rake2");
    setting.dataset = in.text("dataset");
    setting.parameters = read_parameters(in, limits);
    setting.fields = in.texts_or_none("fields", limits.fields);
    setting.if_rev = in.count_if("ifRev", 0, most_rev);
    return setting;
}

SurfaceRecord read_surface_record(CheckedJson& in, const SurfaceLimits& limits) {
    SurfaceLimits once = limits;
    once.fields = std::max(limits.fields, fields_once_allowed);
    const SurfaceSetting setting = read_surface_setting(in, once);
    SurfaceRecord record;
    record.surface = in.text("surface");
    record.rev = in.count("rev", 0, most_rev);
    record.epoch =
        static_cast<std::uint32_t>(in.count("epoch", 0, std::numeric_limits<std::uint32_t>::max()));
    record.rake = setting.rake;
    record.rake2 = setting.rake2;
    record.dataset = setting.dataset;
    record.parameters = setting.parameters;
    record.fields = setting.fields;
    return record;
}

nlohmann::json surface_json(const SurfaceRecord& record) {
    const core::SurfaceParameters& p = record.parameters;
    nlohmann::json out{{"surface", record.surface},
                       {"rev", record.rev},
                       {"epoch", record.epoch},
                       {"rake", record.rake},
                       {"kind", name(p.kind)},
                       {"dataset", record.dataset},
                       {"from", p.from},
                       {"to", p.to},
                       {"direction", name(p.direction)},
                       {"separation", p.separation},
                       {"accuracy", name(p.accuracy)},
                       {"merge", p.merge},
                       {"angle", p.angle},
                       {"maxQuads", p.max_quads},
                       {"fields", record.fields}};
    if (p.release_until)
        out["releaseUntil"] = *p.release_until;
    if (p.sweep)
        out["sweep"] = {p.sweep->x, p.sweep->y, p.sweep->z};
    if (record.rake2)
        out["rake2"] = *record.rake2;
    return out;
}

} // namespace wakesurf::protocol
