// Made by protocol/api/generate from subscription.schema.json: do not edit.
// Looking at surfaces: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/surface_statistics.hpp"
#include "core/surface/value_range.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// the last update that was applied before a connection was lost; the server goes on after it if
/// possible
struct UpdatePlace {
    /// counts the surfaces that have been built for the record; it never decreases
    std::uint32_t epoch = 0;
    /// number of the update in its epoch
    std::uint32_t seq = 0;

    bool operator==(const UpdatePlace&) const = default;
};

/// How long the pass that made the newest state took.
struct PassSeconds {
    /// from the edit, or the state before, until the pass began (s)
    double queue = 0.0;
    /// waiting for time-steps of the velocity (s)
    double load = 0.0;
    /// everything else in building the surface (s)
    double compute = 0.0;
    /// encoding frames (s)
    double encode = 0.0;

    bool operator==(const PassSeconds&) const = default;
};

/// Holds the parameters of surface.stats.
struct SurfaceStats : InSession {
    static constexpr std::string_view method = "surface.stats";

    /// an id from surface.list
    std::string surface;
};

/// Holds the parameters of surface.wait.
struct SurfaceWait : InSession {
    static constexpr std::string_view method = "surface.wait";

    /// an id from surface.list
    std::string surface;
    /// epoch to wait for: this one or a later one; if left out, the current one
    std::optional<std::uint32_t> epoch;
    /// how long to wait, at most (ms)
    std::uint64_t timeout_ms = 0;
    /// on a WebSocket: $/progress reports the progress of the work with this token
    std::optional<std::string> work_done_token;
};

/// Holds the parameters of surface.subscribe.
struct SurfaceSubscribe : InSession {
    static constexpr std::string_view method = "surface.subscribe";

    /// an id from surface.list
    std::string surface;
    /// the last update that was applied before a connection was lost; the server goes on after it
    /// if possible
    std::optional<UpdatePlace> from;
};

/// Holds the parameters of surface.unsubscribe.
struct SurfaceUnsubscribe : InSession {
    static constexpr std::string_view method = "surface.unsubscribe";

    /// number of the subscription; or give `surface` instead
    std::optional<std::uint32_t> subscription;
    /// id of the surface, instead of the number
    std::optional<std::string> surface;
};

/// Holds the parameters of frame.ack.
struct FrameAck {
    static constexpr std::string_view method = "frame.ack";

    /// number of the subscription
    std::uint32_t subscription = 0;
    /// epoch of the update; if left out, the surface's current one
    std::optional<std::uint32_t> epoch;
    /// number of the update in its epoch
    std::uint32_t seq = 0;
};

void read(CheckedJson& in, UpdatePlace& out);
void read(CheckedJson& in, SurfaceStats& out);
void read(CheckedJson& in, SurfaceWait& out);
void read(CheckedJson& in, SurfaceSubscribe& out);
void read(CheckedJson& in, SurfaceUnsubscribe& out);
void read(CheckedJson& in, FrameAck& out);

nlohmann::json pass_seconds_json(const PassSeconds& record);
nlohmann::json terminations_json(const core::SurfaceStatistics::Terminated& record);
nlohmann::json build_seconds_json(const core::SurfaceStatistics::Seconds& record);
nlohmann::json emptiness_json(const core::Emptiness& record);
nlohmann::json statistics_json(const core::SurfaceStatistics& record);
nlohmann::json value_range_json(const core::ValueRange& record);

} // namespace wakesurf::protocol
