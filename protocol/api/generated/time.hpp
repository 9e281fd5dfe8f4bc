// Made by protocol/api/generate from time.schema.json: do not edit.
// The clock: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"
#include "protocol/api/nullable.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`,
/// up to `to`, and there it stops or goes on at `from` (`loop`).
struct ClockRecord {
    /// simulation time; null: never set, surfaces are shown at their end (the dataset's unit of
    /// time)
    std::optional<double> time;
    /// it runs
    bool playing = false;
    /// how fast it runs (simulation time a second)
    double speed = 1.0;
    /// it begins again at the end
    bool loop = false;
    /// what is played begins here; null before it first was (the dataset's unit of time)
    std::optional<double> from;
    /// and ends here (the dataset's unit of time)
    std::optional<double> to;

    bool operator==(const ClockRecord&) const = default;
};

void read(CheckedJson& in, ClockRecord& out);

nlohmann::json clock_json(const ClockRecord& record);

/// As it is kept: what read() reads.
nlohmann::json kept_json(const ClockRecord& record);

/// Parameters of time.set: Jumps to a time: path, streak and time surfaces are shown as they are
/// then, within their own `from` and `to`.
struct TimeSet {
    static constexpr std::string_view method = "time.set";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// simulation time; null: no time, surfaces are shown at their end (the dataset's unit of time)
    Nullable<double> time;

    bool operator==(const TimeSet&) const = default;
};

void read(CheckedJson& in, TimeSet& out);

/// Parameters of time.play: Lets the clock run, from where it stands or from the start.
struct PlaySetting {
    static constexpr std::string_view method = "time.play";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// how fast it runs; left out: as before, at first 1 (simulation time a second)
    std::optional<double> speed;
    /// begin again at the end; left out: as before, at first not
    std::optional<bool> loop;
    /// left out: as before, at first where the first surface begins (the dataset's unit of time)
    std::optional<double> from;
    /// left out: as before, at first where the last surface ends (the dataset's unit of time)
    std::optional<double> to;

    bool operator==(const PlaySetting&) const = default;
};

void read(CheckedJson& in, PlaySetting& out);

/// Parameters of time.pause: Stops the clock where it is.
struct TimePause {
    static constexpr std::string_view method = "time.pause";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const TimePause&) const = default;
};

void read(CheckedJson& in, TimePause& out);

} // namespace wakesurf::protocol
