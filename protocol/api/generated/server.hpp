// Made by protocol/api/generate from server.schema.json: do not edit.
// The server: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Holds the parameters of rpc.discover.
struct RpcDiscover : NoParameters {
    static constexpr std::string_view method = "rpc.discover";
};

/// Holds the parameters of server.info.
struct ServerInfo : NoParameters {
    static constexpr std::string_view method = "server.info";
};

/// Holds the parameters of server.ping.
struct ServerPing : NoParameters {
    static constexpr std::string_view method = "server.ping";
};

/// Holds the parameters of server.stats.
struct ServerStats : NoParameters {
    static constexpr std::string_view method = "server.stats";
};

/// Holds the parameters of $/cancelRequest.
struct CancelRequest {
    static constexpr std::string_view method = "$/cancelRequest";

    /// id of the call
    std::string id;
};

void read(CheckedJson& in, CancelRequest& out);

} // namespace wakesurf::protocol
