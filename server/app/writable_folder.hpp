// Checks that this process can write in a folder of the command line, before anything depends on it.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::server {

/// Checks that files can be made in `folder`, or the folder itself can. Error: Io, naming the owner, the user
/// of this process and the cure. `option` names the option of the folder. Reads the file system, writes
/// nothing.
core::Result<void> check_writable(const std::filesystem::path& folder, std::string_view option);

} // namespace wakesurf::server
