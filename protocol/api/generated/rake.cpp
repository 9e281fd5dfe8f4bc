// Made by protocol/api/generate from rake.schema.json: do not edit.
#include "protocol/api/generated/rake.hpp"

#include "protocol/api/base/colour_text.hpp"
#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, RakeRecord& out) {
    out.rake = in.some_text("rake", 256);
    out.rev = in.count("rev", 0, 9007199254740992);
    in.word("kind", in.text("kind"), rake_kind, out.shape.kind, "line, polyline, circle or points");
    out.shape.points = in.points("points", limits::rake_points);
    out.shape.seeds =
        static_cast<std::uint32_t>(in.count("seeds", limits::seeds_least, limits::seeds_most));
    out.name = in.text_or("name", "", limits::name_bytes);
    out.colour = in.text_or("colour", "", 256);
    if (!out.colour.empty() && !is_colour(out.colour))
        in.fault("colour", "must be written #rrggbb");
    out.author = in.text_or("author", "", limits::name_bytes);
    out.clipped = in.flag_or("clipped", false);
}

void read(CheckedJson& in, RakeSetting& out) {
    out.session = in.text_if("session", 256);
    out.rake = in.text_if("rake", 256);
    in.word("kind", in.text("kind"), rake_kind, out.shape.kind, "line, polyline, circle or points");
    out.shape.points = in.points("points", limits::rake_points);
    out.shape.seeds =
        static_cast<std::uint32_t>(in.count("seeds", limits::seeds_least, limits::seeds_most));
    out.name = in.text_or("name", "", limits::name_bytes);
    if (in.has("colour")) {
        out.colour = in.text("colour", 256);
        if (!is_colour(*out.colour))
            in.fault("colour", "must be written #rrggbb");
    }
    if (in.has("dragging"))
        out.dragging = in.flag_or("dragging", false);
    out.force = in.flag_or("force", false);
    out.default_scene = in.flag_or("default", false);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, RakeDelete& out) {
    out.session = in.text_if("session", 256);
    out.rake = in.text("rake", 256);
    out.force = in.flag_or("force", false);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

nlohmann::json record_json(const RakeRecord& record) {
    nlohmann::json out = kept_json(record);
    out["dragging"] = record.dragging;
    if (!record.leased_by.empty())
        out["leasedBy"] = record.leased_by;
    return out;
}

nlohmann::json kept_json(const RakeRecord& record) {
    return {{"rake", record.rake},
            {"rev", record.rev},
            {"kind", name(record.shape.kind)},
            {"points", points_json(record.shape.points)},
            {"seeds", record.shape.seeds},
            {"name", record.name},
            {"colour", record.colour},
            {"author", record.author},
            {"clipped", record.clipped}};
}

} // namespace wakesurf::protocol
