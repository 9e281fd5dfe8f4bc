// The paths of the programs. A test file that includes this header, also by way of others, starts programs:
// tests/CMakeLists.txt puts it into a *_process_test, and `./check quick` leaves it out.
#pragma once

#include <string>

namespace wakesurf::tests {

/// Returns the path of the server, `wakesurf`.
std::string server_program();

/// Returns the path of `wakesurf-import`.
std::string importer_program();

/// Returns the path of `wakesurf-bricks`, which builds without WAKESURF_MPI do not make.
std::string bricks_program();

} // namespace wakesurf::tests
