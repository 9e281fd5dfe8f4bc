// A line of the log for each call, at level debug: which method, by whom, on what. Never what it said.
#pragma once

#include "server/rpc/method.hpp"

namespace wakesurf::server {

/// Cost while nobody listens: one comparison.
void log_call(const Method& method, const Call& call);

} // namespace wakesurf::server
