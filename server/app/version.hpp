// The output of `wakesurf --version`: the program's version and those of everything it reads, writes and
// speaks.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::server {

/// The commit that the program was built from, made by built_commit.cmake in each build and linked to the program alone.
/// Returns twelve digits, with "with changes" if files were not committed; "unknown" without a repository.
std::string_view built_commit();

/// Returns the program's version, as 0.1.0: the one in the build's CMakeLists.txt.
std::string_view version_number();

/// Returns one line each, the program's first, then the commit it was built from: docs/versions.md says what
/// each number means and what happens to older ones.
std::string version_text(std::string_view commit);

} // namespace wakesurf::server
