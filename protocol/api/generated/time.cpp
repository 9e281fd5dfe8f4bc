// Made by protocol/api/generate from time.schema.json: do not edit.
#include "protocol/api/generated/time.hpp"

#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

void read(CheckedJson& in, ClockRecord& out) {
    out.time = in.number_if("time", -1e+30, 1e+30);
    out.playing = in.flag_or("playing", false);
    out.speed = in.number_or("speed", 1e-09, limits::clock_speed, 1.0);
    out.loop = in.flag_or("loop", false);
    out.from = in.number_if("from", -1e+30, 1e+30);
    out.to = in.number_if("to", -1e+30, 1e+30);
    if (out.from && out.to && !(*out.from < *out.to))
        in.fault("to", "must be later than `from`");
    if (out.from.has_value() != out.to.has_value())
        in.fault("to", "goes with `from`");
    if (out.playing && !(out.time && out.from))
        in.fault("playing", "needs `time` and `from`");
}

void read(CheckedJson& in, TimeSet& out) {
    out.session = in.text_if("session", 256);
    out.time.given = in.given("time");
    if (!out.time.given)
        in.fault("time", "is missing; null stops the clock");
    out.time.value = in.number_if("time", -1e+30, 1e+30);
}

void read(CheckedJson& in, PlaySetting& out) {
    out.session = in.text_if("session", 256);
    out.speed = in.number_if("speed", 1e-09, limits::clock_speed);
    if (in.has("loop"))
        out.loop = in.flag_or("loop", false);
    out.from = in.number_if("from", -1e+30, 1e+30);
    out.to = in.number_if("to", -1e+30, 1e+30);
    if (out.from && out.to && !(*out.from < *out.to))
        in.fault("to", "must be later than `from`");
}

nlohmann::json record_json(const ClockRecord& record) {
    return kept_json(record);
}

nlohmann::json kept_json(const ClockRecord& record) {
    return {{"time", record.time ? nlohmann::json(*record.time) : nlohmann::json(nullptr)},
            {"playing", record.playing},
            {"speed", record.speed},
            {"loop", record.loop},
            {"from", record.from ? nlohmann::json(*record.from) : nlohmann::json(nullptr)},
            {"to", record.to ? nlohmann::json(*record.to) : nlohmann::json(nullptr)}};
}

} // namespace wakesurf::protocol
