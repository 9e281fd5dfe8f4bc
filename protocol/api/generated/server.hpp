// Made by protocol/api/generate from server.schema.json: do not edit.
// The server: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of rpc.discover: Returns this description as an OpenRPC document: every method with
/// its parameters. The example shows only a part of the document.
struct RpcDiscover {
    static constexpr std::string_view method = "rpc.discover";
};

void read(CheckedJson& in, RpcDiscover& out);

/// Parameters of server.info: Reports what this server is, what it offers, and what its limits are.
struct ServerInfo {
    static constexpr std::string_view method = "server.info";
};

void read(CheckedJson& in, ServerInfo& out);

/// Parameters of server.ping: Returns at once. Clients use it as their heartbeat.
struct ServerPing {
    static constexpr std::string_view method = "server.ping";
};

void read(CheckedJson& in, ServerPing& out);

/// Parameters of server.stats: Reports how long each stage from an edit to the socket took in the
/// last minute, and how the server is doing. With a share link it returns only participants,
/// surfaces, stages and firstFrame, where participants and surfaces are those of the link's
/// session.
struct ServerStats {
    static constexpr std::string_view method = "server.stats";
};

void read(CheckedJson& in, ServerStats& out);

/// Parameters of $/cancelRequest: A notification. The open call of this WebSocket with this id
/// fails at once with the error -32800, and its work stops. What an edit has changed stays changed.
struct CancelRequest {
    static constexpr std::string_view method = "$/cancelRequest";

    /// id of the call
    std::string id;

    bool operator==(const CancelRequest&) const = default;
};

void read(CheckedJson& in, CancelRequest& out);

} // namespace wakesurf::protocol
