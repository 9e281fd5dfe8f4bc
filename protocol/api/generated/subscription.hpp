// Made by protocol/api/generate from subscription.schema.json: do not edit.
// Looking at surfaces: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

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

void read(CheckedJson& in, UpdatePlace& out);

/// Parameters of surface.stats: Returns statistics of the newest state of a surface.
struct SurfaceStats {
    static constexpr std::string_view method = "surface.stats";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;

    bool operator==(const SurfaceStats&) const = default;
};

void read(CheckedJson& in, SurfaceStats& out);

/// Parameters of surface.wait: Returns once the surface is complete; `complete` is false if the
/// time ran out.
struct SurfaceWait {
    static constexpr std::string_view method = "surface.wait";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;
    /// epoch to wait for: this one or a later one; if left out, the current one
    std::optional<std::uint32_t> epoch;
    /// how long to wait, at most (ms)
    std::uint64_t timeout_ms = 0;
    /// on a WebSocket: $/progress reports the progress of the work with this token
    std::optional<std::string> work_done_token;

    bool operator==(const SurfaceWait&) const = default;
};

void read(CheckedJson& in, SurfaceWait& out);

/// Parameters of surface.subscribe: Sends the mesh of a surface as binary frames, now and after
/// every change. It cannot be part of a batch.
struct SurfaceSubscribe {
    static constexpr std::string_view method = "surface.subscribe";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;
    /// the last update that was applied before a connection was lost; the server goes on after it
    /// if possible
    std::optional<UpdatePlace> from;

    bool operator==(const SurfaceSubscribe&) const = default;
};

void read(CheckedJson& in, SurfaceSubscribe& out);

/// Parameters of surface.unsubscribe: Ends a subscription. A surface that someone had subscribed
/// to, and that no one shows or waits for two seconds later, is not computed any further: until
/// someone subscribes to it or waits for it.
struct SurfaceUnsubscribe {
    static constexpr std::string_view method = "surface.unsubscribe";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// number of the subscription; or give `surface` instead
    std::optional<std::uint32_t> subscription;
    /// id of the surface, instead of the number
    std::optional<std::string> surface;

    bool operator==(const SurfaceUnsubscribe&) const = default;
};

void read(CheckedJson& in, SurfaceUnsubscribe& out);

/// Parameters of frame.ack: Reports the last update of a subscription that the client has applied.
/// The server then sends at most eight updates beyond the reported one. Best sent as a
/// notification.
struct FrameAck {
    static constexpr std::string_view method = "frame.ack";

    /// number of the subscription
    std::uint32_t subscription = 0;
    /// epoch of the update; if left out, the surface's current one
    std::optional<std::uint32_t> epoch;
    /// number of the update in its epoch
    std::uint32_t seq = 0;

    bool operator==(const FrameAck&) const = default;
};

void read(CheckedJson& in, FrameAck& out);

} // namespace wakesurf::protocol
