// What the manual page says besides commands and options.
#pragma once

#include <string_view>

namespace wakesurf::server {

/// In roff: environment, files, exit status, examples.
std::string_view manual_chapters();

} // namespace wakesurf::server
