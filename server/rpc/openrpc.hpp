// The method table as an OpenRPC document, for rpc.discover and GET /openrpc.json.
#pragma once

#include "server/rpc/method.hpp"

#include <string>
#include <vector>

namespace wakesurf::server {

std::string openrpc_document(const std::vector<Method>& methods);

} // namespace wakesurf::server
