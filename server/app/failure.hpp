// The end of every failed command: one line on standard error, exit status 1, or 2 for wrong usage.
#pragma once

#include "core/base/result.hpp"

namespace wakesurf::server {

inline constexpr int wrong_usage = 2; ///< exit status

/// Prints `wakesurf: MESSAGE (HINT)`; returns the exit status.
int report_failure(const core::Error& error);

} // namespace wakesurf::server
