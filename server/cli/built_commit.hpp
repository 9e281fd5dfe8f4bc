// Which commit the program was built from. Its source is made by built_commit.cmake in each build, and linked to the program alone.
#pragma once

#include <string_view>

namespace wakesurf::server {

/// Twelve digits, and "with changes" where files were not committed; "unknown" where nothing says.
std::string_view built_commit();

} // namespace wakesurf::server
