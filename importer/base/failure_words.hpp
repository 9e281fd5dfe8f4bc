// Exceptions put into words for users who want a file read.
#pragma once

#include "core/base/result.hpp"

#include <exception>
#include <string>

namespace wakesurf::importer {

/// Returns an error about `what`, a file or a time-step: OverLimit for memory, else Corrupt or Io.
core::Error error_of(const std::exception& thrown, const std::string& what);

} // namespace wakesurf::importer
