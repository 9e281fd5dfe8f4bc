// Finds the times of an OpenFOAM case that have a velocity and its last mesh, and its regions that are fluid.
#pragma once

#include "importer/sources/openfoam/openfoam_case.hpp"

#include <set>

namespace wakesurf::importer {

/// Returns the names of possible fields in a time folder, without .gz and without copies that OpenFOAM itself
/// ignores.
std::set<std::string> foam_fields(const std::filesystem::path& folder);

/// Lists the time folders of one part, by value. Error: Corrupt where two have the same value.
core::Result<std::vector<FoamTime>> list_foam_times(const std::filesystem::path& folder,
                                                    const std::string& part);

/// Sets `times` and the fluid regions: those with a velocity, which is U, or else the vector field of most
/// times. Times that not all processors have are left out, with a note; so is the last one if their files
/// differ. Error: NotFound (no velocity anywhere, or at no time on all processors), Corrupt.
core::Result<void> find_foam_times(FoamCase& found);

/// Sets `mesh_times`. Compares every mesh file in a time folder with the one used before; files that are
/// equal but for their headers are no change. snappyHexMesh leaves its mesh in a time folder, and a run from
/// there leaves the fields of the background mesh behind: only times with the last mesh stay, with a note on
/// the others. Error: Unsupported naming the first file that differs, if the mesh changes as the run goes:
/// its points move, or it is another one at every time. Cost: reads those files.
core::Result<void> keep_times_of_last_mesh(FoamCase& found);

} // namespace wakesurf::importer
