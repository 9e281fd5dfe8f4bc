// Made by protocol/api/generate from presence.schema.json: do not edit.
#include "protocol/api/generated/presence.hpp"

#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, CameraPose& out) {
    out.position = in.point("position");
    out.target = in.point("target");
    out.up = in.point("up");
    out.fov = in.number_if("fov", 1.0, 179.0);
}

void read(CheckedJson& in, DraggedRake& out) {
    out.rake = in.text("rake", 64);
    if (in.has("points"))
        out.points = in.points("points", limits::presence_points);
}

void read(CheckedJson& in, PresenceUpdate& out) {
    out.session = in.text_if("session", 256);
    out.pointer.given = in.given("pointer");
    out.pointer.value = in.point_if("pointer");
    out.camera.given = in.given("camera");
    if (in.has("camera")) {
        out.camera.value.emplace();
        in.inside("camera", [&](CheckedJson& inner) { read(inner, *out.camera.value); });
    }
    out.dragging.given = in.given("dragging");
    if (in.has("dragging")) {
        out.dragging.value.emplace();
        in.inside("dragging", [&](CheckedJson& inner) { read(inner, *out.dragging.value); });
    }
    out.selected.given = in.given("selected");
    out.selected.value = in.text_if("selected", 64);
}

nlohmann::json camera_json(const CameraPose& record) {
    nlohmann::json out{{"position", point_json(record.position)},
                       {"target", point_json(record.target)},
                       {"up", point_json(record.up)}};
    if (record.fov)
        out["fov"] = *record.fov;
    return out;
}

nlohmann::json dragged_rake_json(const DraggedRake& record) {
    return {{"rake", record.rake}, {"points", points_json(record.points)}};
}

} // namespace wakesurf::protocol
