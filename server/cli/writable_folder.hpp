// Whether a folder named on the command line is this process's to write in, said before anything depends on it.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::server {

/// Nothing where files can be made in `folder`, or the folder itself can. Error: Io, naming the owner, the user of
/// this process and the cure. `option` is what the person gave the folder with. Reads the file system, writes nothing.
core::Result<void> check_writable(const std::filesystem::path& folder, std::string_view option);

} // namespace wakesurf::server
