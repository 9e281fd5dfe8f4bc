// The paths of the sources' fixtures, the bundled simulation and the programs. One file is compiled with
// these paths, so that all others compile to the same objects in every clone and are found in the compiler's
// cache.
#pragma once

#include <filesystem>
#include <string>

namespace wakesurf::tests {

std::filesystem::path source_folder();

/// Returns the path of the server, `wakesurf`.
std::string server_program();

/// Returns the path of `wakesurf-import`.
std::string importer_program();

/// Returns the path of `wakesurf-bricks`, which builds without WAKESURF_MPI do not make.
std::string bricks_program();

} // namespace wakesurf::tests
