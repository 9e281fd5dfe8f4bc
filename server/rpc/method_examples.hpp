// A call and its answer for methods where they are short: examples in the OpenRPC document. tests/python/openrpc_test.py checks them against the schemas there.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// {method: {params, result}}, as the server answered.
nlohmann::json method_examples();

} // namespace wakesurf::server
