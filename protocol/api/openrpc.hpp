// The description of the API as an OpenRPC document, for rpc.discover and GET /openrpc.json.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// The version of the API that server.info tells clients: raised whenever a client of before could
/// misunderstand the server.
inline constexpr int api_level = 5;

/// Returns JSON text that names `version`, the program's.
std::string openrpc_document(std::string_view version);

} // namespace wakesurf::protocol
