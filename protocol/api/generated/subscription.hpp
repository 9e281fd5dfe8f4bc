// Made by protocol/api/generate from subscription.schema.json: do not edit.
// Looking at surfaces: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// the newest update folded before a lost connection: go on after it if possible
struct UpdatePlace {
    /// counts the surfaces that a record has had; only grows
    std::uint32_t epoch = 0;
    /// of the update in its epoch
    std::uint32_t seq = 0;

    bool operator==(const UpdatePlace&) const = default;
};

void read(CheckedJson& in, UpdatePlace& out);

/// Parameters of surface.stats: What the newest state of a surface is and took.
struct SurfaceStats {
    static constexpr std::string_view method = "surface.stats";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;

    bool operator==(const SurfaceStats&) const = default;
};

void read(CheckedJson& in, SurfaceStats& out);

/// Parameters of surface.wait: Answers once the surface is complete; `complete` is false when the
/// time ran out.
struct SurfaceWait {
    static constexpr std::string_view method = "surface.wait";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;
    /// this one or a later one; left out: the current
    std::optional<std::uint32_t> epoch;
    /// patience (ms)
    std::uint64_t timeout_ms = 0;
    /// on a WebSocket: $/progress with this token tells how far the work is
    std::optional<std::string> work_done_token;

    bool operator==(const SurfaceWait&) const = default;
};

void read(CheckedJson& in, SurfaceWait& out);

/// Parameters of surface.subscribe: Sends the mesh of a surface, now and after every change, as
/// binary frames. Cannot be part of a batch.
struct SurfaceSubscribe {
    static constexpr std::string_view method = "surface.subscribe";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;
    /// the newest update folded before a lost connection: go on after it if possible
    std::optional<UpdatePlace> from;

    bool operator==(const SurfaceSubscribe&) const = default;
};

void read(CheckedJson& in, SurfaceSubscribe& out);

/// Parameters of surface.unsubscribe: Ends a subscription.
struct SurfaceUnsubscribe {
    static constexpr std::string_view method = "surface.unsubscribe";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// the number, or name the surface
    std::optional<std::uint32_t> subscription;
    /// instead of the number
    std::optional<std::string> surface;

    bool operator==(const SurfaceUnsubscribe&) const = default;
};

void read(CheckedJson& in, SurfaceUnsubscribe& out);

/// Parameters of frame.ack: Says up to which update a subscription's frames have been folded. A
/// client that does so is sent at most eight updates more than that; meant as a notification.
struct FrameAck {
    static constexpr std::string_view method = "frame.ack";

    /// the number
    std::uint32_t subscription = 0;
    /// left out: the surface's current one
    std::optional<std::uint32_t> epoch;
    /// of the update in its epoch
    std::uint32_t seq = 0;

    bool operator==(const FrameAck&) const = default;
};

void read(CheckedJson& in, FrameAck& out);

} // namespace wakesurf::protocol
