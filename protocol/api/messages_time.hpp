// A session's clock in messages: what time.play asks for, and the record everybody in the session sees. Between two records
// clients carry the time on by themselves: it runs at `speed`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace wakesurf::protocol {

struct PlaySetting {
    std::optional<double> speed; ///< simulation time a second; nothing: as before
    std::optional<bool> loop;
    std::optional<double> from, to;
};

/// Reads the parameters of time.play; faults stay in `in`.
PlaySetting read_play_setting(CheckedJson& in, double most_speed);

/// Reads `time`: null is no time.
std::optional<double> read_clock_time(CheckedJson& in, const nlohmann::json& parameters);

struct ClockRecord {
    std::optional<double> time; ///< simulation time as the record is made; nothing: never set
    bool playing = false;
    double speed = 1.0;
    bool loop = false;
    std::optional<double> from, to; ///< what is played; nothing before the first time.play

    bool operator==(const ClockRecord&) const = default;
};

nlohmann::json clock_json(const ClockRecord& record);

/// What clock_json gave; faults stay in `in`.
ClockRecord read_clock_record(CheckedJson& in, double most_speed);

} // namespace wakesurf::protocol
