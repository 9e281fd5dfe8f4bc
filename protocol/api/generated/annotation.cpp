// Made by protocol/api/generate from annotation.schema.json: do not edit.
#include "protocol/api/generated/annotation.hpp"

#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, AnnotationRecord& out) {
    out.annotation = in.some_text("annotation", 256);
    out.rev = in.count("rev", 0, 9007199254740992);
    out.text = in.lines("text", limits::annotation_bytes);
    out.position = in.point("position");
    out.author = in.text_or("author", "", limits::name_bytes);
    out.surface = in.text_if("surface", 256);
}

void read(CheckedJson& in, AnnotationSetting& out) {
    out.session = in.text_if("session", 256);
    out.annotation = in.text_if("annotation", 256);
    out.text = in.lines("text", limits::annotation_bytes);
    out.position = in.point("position");
    out.surface = in.text_if("surface", 256);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, AnnotationDelete& out) {
    out.session = in.text_if("session", 256);
    out.annotation = in.text("annotation", 256);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

nlohmann::json record_json(const AnnotationRecord& record) {
    return kept_json(record);
}

nlohmann::json kept_json(const AnnotationRecord& record) {
    nlohmann::json out{{"annotation", record.annotation},
                       {"rev", record.rev},
                       {"text", record.text},
                       {"position", point_json(record.position)},
                       {"author", record.author}};
    if (record.surface)
        out["surface"] = *record.surface;
    return out;
}

} // namespace wakesurf::protocol
