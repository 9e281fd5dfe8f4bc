// Does an OpenFOAM case have one mesh for all its time-steps?
#pragma once

#include "server/import/sources/openfoam/openfoam_case.hpp"

namespace wakesurf::server {

/// Compares every mesh file in a time folder with the one the first time-step uses; files that are equal but for their
/// headers are no motion. Error: Unsupported naming the first that differs. Cost: reads those files.
core::Result<void> check_foam_mesh_stands_still(const FoamCase& found);

} // namespace wakesurf::server
