// What clients are told of the disk: that edits are not kept for now, or are again.
#pragma once

#include "core/base/result.hpp"

#include <string>

namespace wakesurf::server {

/// The notification server.notice of kind `durableAgain`, or with an error `notDurable`.
std::string durability_notice(const core::Result<void>& turn);

} // namespace wakesurf::server
