// Made by protocol/api/generate from bookmark.schema.json: do not edit.
#include "protocol/api/generated/bookmark.hpp"

#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, BookmarkRecord& out) {
    out.bookmark = in.some_text("bookmark", 256);
    out.rev = in.count("rev", 0, 9007199254740992);
    out.name = in.text_or("name", "", limits::name_bytes);
    out.view = in.object_text("view", limits::view_bytes);
    out.time = in.number_if("time", -3.4028234663852886e+38, 3.4028234663852886e+38);
}

void read(CheckedJson& in, BookmarkSetting& out) {
    out.session = in.text_if("session", 256);
    out.bookmark = in.text_if("bookmark", 256);
    out.name = in.text_or("name", "", limits::name_bytes);
    out.view = in.object_text("view", limits::view_bytes);
    out.time = in.number_if("time", -3.4028234663852886e+38, 3.4028234663852886e+38);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, BookmarkDelete& out) {
    out.session = in.text_if("session", 256);
    out.bookmark = in.text("bookmark", 256);
    out.gesture = in.some_text_if("gesture", limits::gesture_bytes);
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

nlohmann::json record_json(const BookmarkRecord& record) {
    return kept_json(record);
}

nlohmann::json kept_json(const BookmarkRecord& record) {
    nlohmann::json out{{"bookmark", record.bookmark},
                       {"rev", record.rev},
                       {"name", record.name},
                       {"view", nlohmann::json::parse(record.view)}};
    if (record.time)
        out["time"] = *record.time;
    return out;
}

} // namespace wakesurf::protocol
