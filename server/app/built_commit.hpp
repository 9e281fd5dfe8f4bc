// The commit that the program was built from. Its source is made by built_commit.cmake in each build, and
// linked to the program alone.
#pragma once

#include <string_view>

namespace wakesurf::server {

/// Returns twelve digits, with "with changes" if files were not committed; "unknown" without a repository.
std::string_view built_commit();

} // namespace wakesurf::server
