// Made by protocol/api/generate from time.schema.json: do not edit.
// The clock: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/base/nullable.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string_view>

namespace wakesurf::protocol {

/// The clock of a session. `time` is its time when the message was written. While it is `playing`,
/// it advances by `speed` up to `to`, and there it stops or goes on at `from` (`loop`).
struct ClockRecord {
    /// simulation time; null: it was never set, and surfaces are shown at their end (the dataset's
    /// unit of time)
    std::optional<double> time;
    /// true: the clock runs
    bool playing = false;
    /// how fast the clock runs (simulation time a second)
    double speed = 1.0;
    /// true: the clock goes on at `from` when it reaches `to`
    bool loop = false;
    /// time at which playing starts; null before the clock was first played (the dataset's unit of
    /// time)
    std::optional<double> from;
    /// time at which playing ends; null before the clock was first played (the dataset's unit of
    /// time)
    std::optional<double> to;

    bool operator==(const ClockRecord&) const = default;
};

void read(CheckedJson& in, ClockRecord& out);

nlohmann::json record_json(const ClockRecord& record);

/// Returns it as it is kept: what read() reads.
nlohmann::json kept_json(const ClockRecord& record);

/// Holds the parameters of time.set.
struct TimeSet : InSession {
    static constexpr std::string_view method = "time.set";

    /// simulation time; null: no time, and surfaces are shown at their end (the dataset's unit of
    /// time)
    Nullable<double> time;
};

/// Holds the parameters of time.play.
struct PlaySetting : InSession {
    static constexpr std::string_view method = "time.play";

    /// how fast the clock runs; if left out, as before, at first 1 (simulation time a second)
    std::optional<double> speed;
    /// true: go on at `from` when the clock reaches `to`; if left out, as before, at first false
    std::optional<bool> loop;
    /// time at which playing starts; if left out, as before, at first where the first surface
    /// begins (the dataset's unit of time)
    std::optional<double> from;
    /// time at which playing ends; if left out, as before, at first where the last surface ends
    /// (the dataset's unit of time)
    std::optional<double> to;
};

/// Holds the parameters of time.pause.
struct TimePause : InSession {
    static constexpr std::string_view method = "time.pause";
};

void read(CheckedJson& in, TimeSet& out);
void read(CheckedJson& in, PlaySetting& out);

} // namespace wakesurf::protocol
