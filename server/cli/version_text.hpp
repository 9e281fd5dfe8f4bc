// What `wakesurf --version` prints: the program's version and those of everything it reads, writes and speaks.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::server {

/// Of the program alone, as 0.1.0: the one that the build's CMakeLists.txt names.
std::string_view version_number();

/// One line each, the program's first, then the commit it was built from: docs/versions.md says what each number means and what
/// happens to older ones.
std::string version_text(std::string_view commit);

} // namespace wakesurf::server
