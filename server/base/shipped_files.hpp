// The files shipped with a program, freshly built or installed.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>

namespace wakesurf::server {

/// Returns the running program's file.
std::filesystem::path this_program();

/// Returns the bundled simulation's .pvd: under share/wakesurf of an installation, or beside the sources of a
/// build tree. The first wins, because what lies three folders above an installed program is not ours. Error:
/// NotFound.
core::Result<std::filesystem::path> bundled_simulation();

/// Returns the folder with the client for Python, found in the same way. Error: NotFound.
core::Result<std::filesystem::path> python_client();

} // namespace wakesurf::server
