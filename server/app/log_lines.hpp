// The log's output: lines on standard error, which never block or end the server. No message has an effect on
// a terminal.
#pragma once

#include <string>

namespace wakesurf::server {

/// Logs to standard error from now on. Lines are left out while none can be written, as to a full pipe, one
/// without a reader, or a full disk; the next line that is written states their number. @param level  of
/// spdlog
void log_to_standard_error(const std::string& level);

} // namespace wakesurf::server
