// Made by protocol/api/generate from bookmark.schema.json: do not edit.
#include "protocol/api/generated/bookmark.hpp"

#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, BookmarkRecord& out) {
    out.bookmark = in.text("bookmark", 256);
    if (out.bookmark.empty())
        in.fault("bookmark", "must not be empty");
    out.rev = in.count("rev", 0, 9007199254740992);
    out.name = in.text_or("name", "", limits::name_bytes);
    out.view = in.object_text("view", limits::view_bytes);
    out.time = in.number_if("time", -3.4028234663852886e+38, 3.4028234663852886e+38);
}

nlohmann::json bookmark_json(const BookmarkRecord& record) {
    return kept_json(record);
}

nlohmann::json kept_json(const BookmarkRecord& record) {
    nlohmann::json out = nlohmann::json::object();
    out["bookmark"] = record.bookmark;
    out["rev"] = record.rev;
    out["name"] = record.name;
    out["view"] = nlohmann::json::parse(record.view);
    if (record.time)
        out["time"] = *record.time;
    return out;
}

void read(CheckedJson& in, BookmarkSetting& out) {
    out.session = in.text_if("session", 256);
    out.bookmark = in.text_if("bookmark", 256);
    out.name = in.text_or("name", "", limits::name_bytes);
    out.view = in.object_text("view", limits::view_bytes);
    out.time = in.number_if("time", -3.4028234663852886e+38, 3.4028234663852886e+38);
    if (in.has("gesture")) {
        out.gesture = in.text("gesture", limits::gesture_bytes);
        if (out.gesture->empty())
            in.fault("gesture", "must not be empty: leave it out");
    }
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, BookmarkDelete& out) {
    out.session = in.text_if("session", 256);
    out.bookmark = in.text("bookmark", 256);
    if (in.has("gesture")) {
        out.gesture = in.text("gesture", limits::gesture_bytes);
        if (out.gesture->empty())
            in.fault("gesture", "must not be empty: leave it out");
    }
    out.if_rev = in.count_if("ifRev", 0, 9007199254740992);
}

void read(CheckedJson& in, BookmarkList& out) {
    out.session = in.text_if("session", 256);
}

} // namespace wakesurf::protocol
