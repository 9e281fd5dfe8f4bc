// Writing a file so that it is either whole or not there.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::server {

/// Writes beside the target (`FILE.part`), then renames; an older FILE stays until then. Error: Io.
core::Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes);

} // namespace wakesurf::server
