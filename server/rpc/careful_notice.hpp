// What everybody is told while a server has not computed what it brought back.
#pragma once

#include "core/base/result.hpp"

#include <string>

namespace wakesurf::server {

/// Why surfaces that were brought back are not computed, after so many starts that died.
core::Error withheld(unsigned died);

/// A whole `server.notice` that says so.
std::string careful_notice(unsigned died);

} // namespace wakesurf::server
