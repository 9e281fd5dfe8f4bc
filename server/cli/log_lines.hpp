// Where the log goes: lines on standard error, for which the server never waits and by which it never ends. No message acts on a terminal.
#pragma once

#include <string>

namespace wakesurf::server {

/// From now on. Lines are left out while the reader takes none, as a pipe that is full or has lost its reader, and a disk that is full; the
/// first line that is taken again says how many. @param level  of spdlog
void log_to_standard_error(const std::string& level);

} // namespace wakesurf::server
