// Made by protocol/api/generate from family.schema.json: do not edit.
#include "protocol/api/generated/family.hpp"

#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, FamilyMake& out) {
    out.dataset = in.text("dataset", 256);
    out.name = in.some_text("name", 64);
    out.from = in.text("from");
    if (out.from != "inflow" && out.from != "plane" && out.from != "curve")
        in.fault("from", "must be inflow, plane or curve");
    out.scalar = in.text_or("scalar", "", 256);
    out.point = in.point_if("point");
    out.normal = in.point_if("normal");
    if (in.has("rakeKind"))
        in.word("rakeKind", in.text("rakeKind"), rake_kind, out.rake_kind,
                "line, polyline, circle or points");
    if (in.has("points"))
        out.points = in.points("points", limits::rake_points);
    out.time = in.number_if("time", -3.4028234663852886e+38, 3.4028234663852886e+38);
    in.word("accuracy", in.text_or("accuracy", "balanced"), accuracy, out.accuracy,
            "fast, balanced or exact");
    out.length = in.number_if("length", 0.0, 1e+30);
    if (out.length && !(*out.length > 0.0))
        in.fault("length", "must be a number greater than 0");
    out.work_done_token = in.token_if("workDoneToken", true);
}

void read(CheckedJson& in, FamilyRemove& out) {
    out.dataset = in.text("dataset", 256);
    out.name = in.some_text("name", 64);
}

} // namespace wakesurf::protocol
