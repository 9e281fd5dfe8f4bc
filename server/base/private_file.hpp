// A file with a secret in it: only its owner may read it, and no one ever sees half of it.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::server {

/// Replaces the file (0600), or makes it; a link is replaced, not followed. Does not wait for the disk. Error: Io, without the path.
core::Result<void> write_private_file(const std::filesystem::path& file, std::string_view text);

} // namespace wakesurf::server
