// The quota a method can run into, for data.limit of its error -32014.
#pragma once

#include "protocol/json_rpc.hpp"

#include <string_view>

namespace wakesurf::server {

/// `fault`, an OverLimit of `method`, with data.limit: the most there may be, or null where the machine's memory is the limit.
protocol::RpcFault with_limit(const protocol::RpcFault& fault, std::string_view method);

} // namespace wakesurf::server
