// The time of one pass over a surface, stage by stage, as reported to clients.
#pragma once

#include "protocol/api/generated/subscription.hpp"

namespace wakesurf::server {

using protocol::PassSeconds;

} // namespace wakesurf::server
