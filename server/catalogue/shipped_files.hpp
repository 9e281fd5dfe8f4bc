// Where a freshly built or installed program finds what it ships with.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>

namespace wakesurf::server {

/// The running program's file.
std::filesystem::path this_program();

/// The bundled simulation's .pvd: beside the sources of a build tree, or under share/wakesurf of an installation.
/// Error: NotFound.
core::Result<std::filesystem::path> bundled_simulation();

} // namespace wakesurf::server
