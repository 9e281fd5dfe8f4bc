// Where tests find the sources' fixtures, the bundled simulation and the programs. One file is compiled with these places, so that
// all others compile to the same objects in every clone and are found in the compiler's cache.
#pragma once

#include <filesystem>
#include <string>

namespace wakesurf::tests {

std::filesystem::path source_folder();

/// The server, `wakesurf`.
std::string server_program();

/// `wakesurf-import`.
std::string importer_program();

/// `wakesurf-bricks`, which is not there in builds without WAKESURF_MPI.
std::string bricks_program();

} // namespace wakesurf::tests
