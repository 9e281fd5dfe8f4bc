// Which time-steps of an OpenFOAM case have one mesh?
#pragma once

#include "importer/sources/openfoam/openfoam_case.hpp"

namespace wakesurf::importer {

/// Sets `mesh_times`. Compares every mesh file in a time folder with the one used before; files that are equal but for their headers are no
/// change. snappyHexMesh leaves its mesh in a time folder, and a run from there leaves the fields of the background mesh behind: of the times
/// those stay that have the last mesh, with a note on the others.
/// Error: Unsupported naming the first file that differs, where the mesh changes as the run goes: its points move, or it is another one at
/// every time. Cost: reads those files.
core::Result<void> keep_times_of_last_mesh(FoamCase& found);

} // namespace wakesurf::importer
