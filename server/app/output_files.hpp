// Files and folders that a command writes.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::server {

/// Writes a file so that it is either whole or not there: beside the target (`FILE.part`), then renames; an older FILE stays until then. Error: Io.
core::Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// Checks that files can be made in `folder`, or the folder itself can. Error: Io, naming the owner, the user
/// of this process and the cure. `option` names the option of the folder. Reads the file system, writes
/// nothing.
core::Result<void> check_writable(const std::filesystem::path& folder, std::string_view option);

} // namespace wakesurf::server
