#include "protocol/api/messages_time.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

namespace {

constexpr double most_time = 1e30;
constexpr double least_speed = 1e-9;

nlohmann::json or_null(const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

} // namespace

PlaySetting read_play_setting(CheckedJson& in, double most_speed) {
    PlaySetting setting;
    setting.speed = in.number_if("speed", least_speed, most_speed);
    if (in.has("loop"))
        setting.loop = in.flag_or("loop", false);
    setting.from = in.number_if("from", -most_time, most_time);
    setting.to = in.number_if("to", -most_time, most_time);
    if (setting.from && setting.to && !(*setting.from < *setting.to))
        in.fault("to", "must be later than `from`");
    return setting;
}

std::optional<double> read_clock_time(CheckedJson& in, const nlohmann::json& parameters) {
    const bool given = parameters.is_object() && parameters.contains("time");
    const auto time = in.number_if("time", -most_time, most_time);
    if (!given)
        in.fault("time", "is missing; null stops the clock");
    return time;
}

nlohmann::json clock_json(const ClockRecord& record) {
    return {{"time", or_null(record.time)}, {"playing", record.playing},
            {"speed", record.speed},        {"loop", record.loop},
            {"from", or_null(record.from)}, {"to", or_null(record.to)}};
}

ClockRecord read_clock_record(CheckedJson& in, double most_speed) {
    const PlaySetting played = read_play_setting(in, most_speed);
    ClockRecord record;
    record.time = in.number_if("time", -most_time, most_time);
    record.playing = in.flag_or("playing", false);
    record.speed = played.speed.value_or(record.speed);
    record.loop = played.loop.value_or(record.loop);
    record.from = played.from;
    record.to = played.to;
    if (record.from.has_value() != record.to.has_value())
        in.fault("to", "goes with `from`");
    if (record.playing && !(record.time && record.from))
        in.fault("playing", "needs a time and what is played");
    return record;
}

} // namespace wakesurf::protocol
