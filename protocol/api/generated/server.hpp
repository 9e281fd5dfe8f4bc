// Made by protocol/api/generate from server.schema.json: do not edit.
// The server: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of rpc.discover: This description as an OpenRPC document: every method with its
/// parameters.
struct RpcDiscover {
    static constexpr std::string_view method = "rpc.discover";
};

void read(CheckedJson& in, RpcDiscover& out);

/// Parameters of server.info: What this server is, what it offers, and what it grants.
struct ServerInfo {
    static constexpr std::string_view method = "server.info";
};

void read(CheckedJson& in, ServerInfo& out);

/// Parameters of server.ping: Answers at once: a client's heartbeat.
struct ServerPing {
    static constexpr std::string_view method = "server.ping";
};

void read(CheckedJson& in, ServerPing& out);

/// Parameters of server.stats: How long each stage from an edit to the socket took in the last
/// minute, and how the server stands; with a share link only how its session does: participants,
/// surfaces, stages and firstFrame.
struct ServerStats {
    static constexpr std::string_view method = "server.stats";
};

void read(CheckedJson& in, ServerStats& out);

/// Parameters of $/cancelRequest: A notification: answers an open call of this WebSocket with
/// -32800 at once and stops its work. What an edit has changed stays changed.
struct CancelRequest {
    static constexpr std::string_view method = "$/cancelRequest";

    /// of the call
    std::string id;

    bool operator==(const CancelRequest&) const = default;
};

void read(CheckedJson& in, CancelRequest& out);

} // namespace wakesurf::protocol
