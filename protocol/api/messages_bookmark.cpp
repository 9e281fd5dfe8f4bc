#include "protocol/api/messages_bookmark.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace wakesurf::protocol {

BookmarkSetting read_bookmark_setting(CheckedJson& in, const BookmarkLimits& limits) {
    constexpr double any_time = std::numeric_limits<float>::max();
    BookmarkSetting setting;
    if (in.has("bookmark"))
        setting.bookmark = in.text("bookmark");
    setting.name = in.text_or("name", {}, limits.name_bytes);
    setting.view = in.object_text("view", limits.view_bytes);
    setting.time = in.number_if("time", -any_time, any_time);
    setting.if_rev = in.count_if("ifRev", 0, most_rev);
    return setting;
}

BookmarkRecord read_bookmark_record(CheckedJson& in, const BookmarkLimits& limits) {
    BookmarkSetting setting = read_bookmark_setting(in, limits);
    return {in.text("bookmark"), in.count("rev", 0, most_rev), std::move(setting.name),
            std::move(setting.view), setting.time};
}

nlohmann::json bookmark_json(const BookmarkRecord& record) {
    nlohmann::json out{{"bookmark", record.bookmark},
                       {"rev", record.rev},
                       {"name", record.name},
                       {"view", nlohmann::json::parse(record.view)}};
    if (record.time)
        out["time"] = *record.time;
    return out;
}

} // namespace wakesurf::protocol
