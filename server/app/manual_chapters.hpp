// The chapters of the manual page besides commands and options.
#pragma once

#include <string_view>

namespace wakesurf::server {

/// Returns environment, files, exit status and examples, in roff.
std::string_view manual_chapters();

} // namespace wakesurf::server
