// What `wakesurf --version` prints: the program's version and those of everything it reads, writes and speaks.
#pragma once

#include <string>

namespace wakesurf::server {

/// One line each, the program's first: docs/versions.md says what each number means and what happens to older ones.
std::string version_text();

} // namespace wakesurf::server
